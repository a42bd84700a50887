#include "app/wave_strip/note_grips.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

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

}  // namespace tact
