#include "app/wave_strip/parts.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/wave_strip/wave_strip.h"
#include "model/pattern/rhythm_edit.h"

namespace tact {

std::vector<NoteBlock> note_blocks(const Pattern& pattern, const StripScale& scale) {
    std::vector<NoteBlock> blocks;
    if (pattern.rhythm.text.empty()) return blocks;
    const Rect& lane = scale.amplitude.area;
    const std::vector<Note> all = notes(pattern.rhythm, pattern.duration_s);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const float left = to_pixel(scale.amplitude.x, all[k].onset_s);
        const float right = to_pixel(scale.amplitude.x, all[k].onset_s + all[k].length_s);
        if (right < lane.min.x || left > lane.max.x) continue;
        const float height = static_cast<float>(all[k].velocity) * scale.note_px;
        blocks.push_back(
            {k, {{left, lane.max.y - scale.note_px}, {right, lane.max.y}}, lane.max.y - height});
    }
    return blocks;
}

namespace {

bool is_in_row(const StripScale& scale, ImVec2 mouse) {
    const Rect& lane = scale.amplitude.area;
    if (scale.tool == StripTool::notes) return lane.contains(mouse);
    return lane.contains(mouse) && mouse.y >= lane.max.y - scale.note_px;
}

}  // namespace

bool is_note(GripKind kind) {
    return kind == GripKind::note_start || kind == GripKind::note || kind == GripKind::note_end ||
           kind == GripKind::note_top;
}

double strength_at(const StripScale& scale, ImVec2 mouse) {
    const float from_floor = scale.amplitude.area.max.y - mouse.y;
    return std::clamp(static_cast<double>(from_floor / scale.note_px), 1.0 / 9.0, 1.0);
}

std::optional<Grip> note_grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                                 float reach_px) {
    if (!is_in_row(scale, mouse)) return std::nullopt;
    std::optional<Grip> edge;
    std::optional<Grip> whole;
    float nearest_px = reach_px;
    const auto consider = [&](GripKind kind, std::size_t index, float outside_px, float inner_px) {
        const float off_px = std::abs(outside_px);
        if (off_px > nearest_px || -outside_px > inner_px) return;
        edge = Grip{kind, index};
        nearest_px = off_px;
    };
    const bool is_high = scale.tool == StripTool::notes;
    std::optional<Grip> top;
    for (const auto& [index, area, own_top_px] : note_blocks(pattern, scale)) {
        const float top_px = is_high ? own_top_px : area.min.y;
        const bool is_over = mouse.x >= area.min.x && mouse.x <= area.max.x;
        if (is_high && is_over && std::abs(mouse.y - top_px) <= reach_px) {
            top = Grip{GripKind::note_top, index};
        }
        if (mouse.y < top_px) continue;
        const float inner_px = area.width() / 3.0F;
        consider(GripKind::note_start, index, area.min.x - mouse.x, inner_px);
        consider(GripKind::note_end, index, mouse.x - area.max.x, inner_px);
        if (is_over) whole = Grip{GripKind::note, index};
    }
    if (top) return top;
    return edge ? edge : whole;
}

NoteSnap snap_of(const GripDrag& drag) {
    if (drag.free) return NoteSnap::quarter;
    return drag.along_one_axis ? NoteSnap::beat : NoteSnap::step;
}

double time_dragged_s(const StripScale& scale, const GripDrag& drag) {
    const Axis& time = scale.amplitude.x;
    return to_value(time, drag.to.x) - to_value(time, drag.from.x);
}

std::ptrdiff_t steps_moved(const Rhythm& rhythm, std::size_t from, double by_s, NoteSnap snap) {
    const double steps = by_s / rhythm.unit_s;
    if (snap != NoteSnap::beat) return std::llround(steps);
    const auto at = static_cast<std::ptrdiff_t>(from);
    const int beat = rhythm.meter.steps_a_beat;
    return std::llround((static_cast<double>(from) + steps) / beat) * beat - at;
}

Rhythm with_note_dragged(const Rhythm& rhythm, const Grip& grip, double by_s, NoteSnap snap) {
    constexpr std::size_t kQuarters = 4;
    const bool free = snap == NoteSnap::quarter;
    const Rhythm grid = free ? refined(rhythm, kQuarters) : rhythm;
    const std::vector<NoteSteps> all = note_steps(grid.text);
    if (all.empty()) return rhythm;
    const std::size_t k = grip.index % all.size();
    NotePart part = NotePart::whole;
    if (grip.kind == GripKind::note_start) part = NotePart::start;
    if (grip.kind == GripKind::note_end) part = NotePart::end;
    const std::size_t from = part == NotePart::end ? all[k].last + 1 : all[k].first;
    const std::ptrdiff_t steps = steps_moved(grid, from, by_s, snap);
    Rhythm moved = grid;
    moved.text = with_note_moved(grid.text, k, part, steps);
    if (!free) return moved;
    moved = coarsened(moved, kQuarters);
    moved.meter = with_step(rhythm.meter, rhythm.unit_s, moved.unit_s);
    return moved;
}

std::optional<Rhythm> with_note_added(const Pattern& pattern, const StripScale& scale,
                                      ImVec2 mouse) {
    constexpr std::size_t kSteps = 16;
    Rhythm rhythm = pattern.rhythm;
    if (rhythm.text.empty() && scale.tool == StripTool::notes) {
        rhythm.text = std::string(kSteps, '-');
        rhythm.unit_s = pattern.duration_s / kSteps;
    }
    const double t_s = to_value(scale.amplitude.x, mouse.x);
    const bool is_within = t_s >= 0.0 && t_s < pattern.duration_s;
    if (rhythm.text.empty() || !is_in_row(scale, mouse) || !is_within) return std::nullopt;
    const std::size_t step = static_cast<std::size_t>(t_s / rhythm.unit_s) % rhythm.text.size();
    if (rhythm.text[step] != '-') return std::nullopt;
    rhythm.text = with_note(rhythm.text, step, step);
    return rhythm;
}

std::optional<Grip> end_of_note_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse) {
    const double t_s = to_value(scale.amplitude.x, mouse.x);
    const std::vector<Note> all = notes(pattern.rhythm, pattern.duration_s);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_there = t_s >= all[k].onset_s && t_s < all[k].onset_s + pattern.rhythm.unit_s;
        if (is_there) return Grip{GripKind::note_end, k};
    }
    return std::nullopt;
}

Rhythm with_note_strength(const Rhythm& rhythm, const Grip& grip, double strength) {
    const std::vector<NoteSteps> all = note_steps(rhythm.text);
    if (all.empty()) return rhythm;
    Rhythm changed = rhythm;
    char& mark = changed.text[all[grip.index % all.size()].first];
    const double pitch = kind_of(rhythm, mark).pitch;
    mark = 'x';  // its letter can be used again if no other note has it
    const auto changed_mark = mark_for(changed, {std::round(9.0 * strength) / 9.0, pitch});
    if (!changed_mark) return rhythm;
    mark = *changed_mark;
    return changed;
}

Rhythm with_note_removed(const Rhythm& rhythm, const Grip& grip) {
    const std::size_t count = note_steps(rhythm.text).size();
    if (count == 0) return rhythm;
    Rhythm changed = rhythm;
    changed.text = without_note(rhythm.text, grip.index % count);
    return changed;
}

namespace {

// The pattern whose notes are chosen; null without chosen notes.
const Pattern* pattern_of_choice(const Workspace& work, const StripState& strip) {
    const bool is_there =
        shown_name(work) == strip.pattern && strip.tool == StripTool::notes && !strip.notes.empty();
    return is_there ? editable_layer(work) : nullptr;
}

}  // namespace

bool has_chosen_notes(const Workspace& work, const StripState& strip) {
    return pattern_of_choice(work, strip) != nullptr;
}

void take_rhythm(Workspace& work, const Pattern& before, const Pattern& changed) {
    const bool has_grown = changed.duration_s > before.duration_s;
    edit_patterns(work, [&](Pattern& pattern) {
        pattern.rhythm = changed.rhythm;
        if (has_grown && pattern.duration_s < changed.duration_s) {
            pattern = with_duration(pattern, changed.duration_s);
        }
    });
}

void choose_note(StripState& strip, const Pattern& pattern, std::size_t index) {
    strip.notes = {};
    toggle_note(strip, pattern, index);
}

void toggle_note(StripState& strip, const Pattern& pattern, std::size_t index) {
    const std::vector<NoteSteps> all = steps_of_notes(pattern);
    if (index < all.size()) strip.notes = with_toggled(pattern, strip.notes, all[index].first);
}

void choose_boxed(StripState& strip, const Pattern& pattern, float click_px) {
    const NoteBox box = *std::exchange(strip.box, std::nullopt);
    strip.notes = {};
    if (std::abs(box.to_px - box.from_px) <= click_px) return;
    const auto step_at = [&](float px) {
        const double s = std::clamp(to_value(box.scale.amplitude.x, px), 0.0, pattern.duration_s);
        return static_cast<std::size_t>(std::llround(s / pattern.rhythm.unit_s));
    };
    const std::size_t first = step_at(std::min(box.from_px, box.to_px));
    const std::size_t end = step_at(std::max(box.from_px, box.to_px));
    const ChosenNotes chosen = notes_within(pattern, {first, std::max(first + 1, end) - 1});
    if (!chosen.empty()) strip.notes = chosen;
}

bool drag_chosen_notes(Ui& ui, Workspace& work, StripState& strip, const GripDrag& drag) {
    const GripHold& held = *strip.held;
    const bool moves = held.grip.kind == GripKind::note;
    if (held.notes.onsets.size() < 2 || (!moves && held.grip.kind != GripKind::note_top)) {
        return false;
    }
    const Pattern& before = held.before;
    const std::size_t own = steps_of_notes(before)[held.grip.index].first;
    const auto edit = [&] {
        if (moves) {
            const double by_s = time_dragged_s(held.scale, drag);
            const NoteSnap snap = drag.along_one_axis ? NoteSnap::beat : NoteSnap::step;
            return with_notes_moved(before, held.notes,
                                    steps_moved(before.rhythm, own, by_s, snap));
        }
        const std::string& text = before.rhythm.text;
        const double was = kind_of(before.rhythm, text[own % text.size()]).velocity;
        const double by = strength_at(held.scale, drag.to) - was;
        return with_notes_stronger(before, held.notes, static_cast<int>(std::lround(9.0 * by)));
    }();
    if (!edit) {
        complain(ui, edit.error().message);
        return true;
    }
    take_rhythm(work, before, edit->pattern);
    strip.notes = edit->chosen;
    return true;
}

void commit_notes(Ui& ui, Workspace& work, StripState& strip, const char* verb,
                  const Expected<NotesEdit>& edit) {
    if (!edit) return complain(ui, edit.error().message);
    const Pattern before = *shown_pattern(work);
    take_rhythm(work, before, edit->pattern);
    strip.notes = edit->chosen;
    commit_step(ui, work, std::string(verb) + " " + of_selection(work, "notes"));
}

bool copy_notes(Ui& ui, const Workspace& work, const StripState& strip) {
    const Pattern* pattern = pattern_of_choice(work, strip);
    if (pattern == nullptr) return false;
    ImGui::SetClipboardText(copied_notes(*pattern, strip.notes).c_str());
    const std::size_t count = strip.notes.onsets.size();
    say(ui, "Copied " + std::to_string(count) + (count == 1 ? " note" : " notes") +
                ". Paste puts them where the mouse is over the strip, or at the playhead.");
    return true;
}

bool repeat_notes(Ui& ui, Workspace& work, StripState& strip, int times) {
    const Pattern* pattern = pattern_of_choice(work, strip);
    if (pattern == nullptr) return false;
    commit_notes(ui, work, strip, times == 2 ? "Double" : "Repeat",
                 with_notes_repeated(*pattern, strip.notes, times));
    return true;
}

bool remove_notes(Ui& ui, Workspace& work, StripState& strip) {
    const Pattern* pattern = pattern_of_choice(work, strip);
    if (pattern == nullptr) return false;
    commit_notes(ui, work, strip, "Remove", without_notes(*pattern, strip.notes));
    return true;
}

bool choose_all_notes(Ui& ui, const Workspace& work, StripState& strip) {
    const Pattern* pattern = pattern_of_choice(work, strip);
    if (pattern == nullptr) return false;
    const std::vector<NoteSteps> all = steps_of_notes(*pattern);
    strip.notes = notes_within(*pattern, {0, all.back().last});
    ui.field.active = kChosenValue;
    return true;
}

bool paste_notes(Ui& ui, Workspace& work, StripState& strip, double playhead_s) {
    const Pattern* pattern = editable_layer(work);
    const char* clipboard = ImGui::GetClipboardText();
    if (pattern == nullptr || strip.tool != StripTool::notes || clipboard == nullptr) return false;
    const std::string text = clipboard;
    if (text.empty() || !rhythm_fault(text).empty()) return false;
    const bool is_pointed_at = shown_name(work) == strip.pattern && strip.pointed_s;
    const double at_s = is_pointed_at ? *strip.pointed_s : playhead_s;
    const double steps = std::max(0.0, at_s) / pattern->rhythm.unit_s;
    constexpr double kOnStep = 1e-6;  // a playhead on a step's start belongs to it
    strip.pattern = shown_name(work);
    commit_notes(ui, work, strip, "Paste",
                 with_notes_pasted(*pattern, static_cast<std::size_t>(steps + kOnStep), text));
    ui.field.active = kChosenValue;
    return true;
}

void choose_next_note(Ui& ui, StripState& strip, const Pattern& pattern, int step) {
    const std::vector<NoteSteps> all = steps_of_notes(pattern);
    if (all.empty()) return say(ui, "The pattern has no notes yet: drag on the strip to draw one.");
    const auto last = all.size() - 1;
    std::size_t next = step < 0 ? last : 0;
    if (!strip.notes.empty()) {
        const auto at =
            std::ranges::lower_bound(all, strip.notes.onsets.front(), {}, &NoteSteps::first);
        const auto k = static_cast<std::size_t>(at - all.begin());
        next = step < 0 ? (k == 0 ? last : k - 1) : (k >= last ? 0 : k + 1);
    }
    choose_note(strip, pattern, next);
    ui.field.active = kChosenValue;
}

}  // namespace tact
