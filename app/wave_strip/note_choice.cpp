#include "app/wave_strip/note_choice.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/document/editing.h"
#include "app/wave_strip/note_grips.h"

namespace tact {

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
