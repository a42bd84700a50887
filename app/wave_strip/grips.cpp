#include "app/wave_strip/wave_strip.h"

#include <algorithm>
#include <cmath>

#include "app/wave_strip/parts.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr double kSnapS = 0.005;
constexpr double kSnapG = 0.01;
constexpr double kSnapHz = 1.0;
constexpr double kLeastTopG = 0.1;
constexpr float kFrequencyShare = 0.42F;
constexpr float kNotePx = 8.0F;
constexpr std::ptrdiff_t kMostGrips = 1000;  // of one kind in view; more would hide the curve

double snapped(double value, double step, bool free) {
    return free ? value : multiple_of(step, std::round(value / step));
}

// The first note, whose ramps stand for those of all.
Note first_note(const Pattern& pattern) {
    const auto all = notes(pattern.rhythm, pattern.duration_s);
    return all.empty() ? Note{} : all.front();
}

double line_g(const Pattern& pattern, double t_s) {
    return pattern.amplitude_g * amplitude_factor(pattern, t_s);
}

Axis frequency_axis(const Pattern& pattern) {
    const Range hz = carrier_range_hz(pattern);
    return {hz.low / 2.0, hz.high * 2.0, Scale::logarithmic};
}

// Movement of a point, in time and along its lane's axis.
struct Step {
    double time_s = 0.0;
    double from = 0.0;  // value on the axis where it was pressed ...
    double to = 0.0;    // ... and at the mouse
};

Step step_of(const Plot& lane, GripDrag drag) {
    const ImVec2 way = drag.to - drag.from;
    if (drag.along_one_axis) {
        (std::abs(way.x) > std::abs(way.y) ? drag.to.y : drag.to.x) =
            std::abs(way.x) > std::abs(way.y) ? drag.from.y : drag.from.x;
    }
    return {to_value(lane.x, drag.to.x) - to_value(lane.x, drag.from.x),
            to_value(lane.y, drag.from.y), to_value(lane.y, drag.to.y)};
}

double moved_within(const Range& room, double time_s, double by_s, bool free) {
    const double to_s = by_s == 0.0 ? time_s : snapped(time_s + by_s, kSnapS, free);
    return std::clamp(to_s, room.low, room.high);
}

void drag_level(Pattern& pattern, const Step& step, bool free) {
    const double ratio = step.from > 0.0 ? step.to / step.from : 1.0;
    const double wanted = pattern.amplitude_g > 0.0 ? pattern.amplitude_g * ratio : step.to;
    pattern.amplitude_g = std::max(0.0, snapped(wanted, kSnapG, free));
}

void drag_frequency(Pattern& pattern, const Step& step, bool free) {
    const double ratio = step.to / step.from;
    if (pattern.frequency_curve.empty()) {
        double& hz = pattern.carriers[0].frequency_hz;
        hz = snapped(hz * ratio, kSnapHz, free);
        return;
    }
    for (FrequencyPoint& point : pattern.frequency_curve) {
        point.frequency_hz =
            std::clamp(point.frequency_hz * ratio, limits::kCarrierHz.low, limits::kCarrierHz.high);
    }
}

void drag_amplitude_point(Pattern& pattern, std::size_t k, const Step& step, bool free) {
    AmplitudePoint& point = pattern.amplitude_curve[k];
    const Range room = room_of(pattern.amplitude_curve, k, pattern.duration_s);
    point.time_s = moved_within(room, point.time_s, step.time_s, free);
    if (pattern.amplitude_g <= 0.0 || step.to == step.from) return;
    const double g = point.value * pattern.amplitude_g + step.to - step.from;
    point.value = std::clamp(snapped(g, kSnapG, free) / pattern.amplitude_g, 0.0, 1.0);
}

void drag_frequency_point(Pattern& pattern, std::size_t k, const Step& step, bool free) {
    FrequencyPoint& point = pattern.frequency_curve[k];
    const Range room = room_of(pattern.frequency_curve, k, pattern.duration_s);
    point.time_s = moved_within(room, point.time_s, step.time_s, free);
    if (step.to == step.from) return;
    point.frequency_hz =
        std::clamp(snapped(point.frequency_hz * step.to / step.from, kSnapHz, free),
                   limits::kCarrierHz.low, limits::kCarrierHz.high);
}

void drag_transient(Transient& transient, double duration_s, const Step& step, bool free) {
    const double time_s = snapped(transient.time_s + step.time_s, kSnapS, free);
    transient.time_s = std::clamp(time_s, 0.0, duration_s);
    const double g = snapped(transient.amplitude_g + step.to - step.from, kSnapG, free);
    transient.amplitude_g = std::clamp(g, 0.0, limits::kAmplitudeG.high);
}

// Points at both ends keep the line in place when the first point is added between them.
template <typename Curve, typename Insert>
std::optional<std::size_t> with_ends(Curve& curve, double t_s, double duration_s, Insert insert) {
    if (!curve.empty()) return insert(t_s);
    for (const double end_s : {0.0, duration_s}) (void)insert(end_s);
    return insert(t_s);
}

}  // namespace

bool is_single(GripKind kind) {
    return kind == GripKind::amplitude_point || kind == GripKind::frequency_point ||
           kind == GripKind::transient;
}

Range carrier_range_hz(const Pattern& pattern) {
    const FrequencyCurve curve = sounding_frequency(pattern);
    if (curve.empty()) {
        const double hz = pattern.carriers[0].frequency_hz;
        return {hz, hz};
    }
    const auto [low, high] = std::ranges::minmax(curve, {}, &FrequencyPoint::frequency_hz);
    return {low.frequency_hz, high.frequency_hz};
}

StripScale strip_scale(const Pattern& pattern, double peak_g, const Rect& area, const Theme& theme,
                       const TimeRange& view, StripTool tool) {
    double top_g = std::max({kLeastTopG, pattern.amplitude_g, peak_g});
    for (const Transient& transient : pattern.transients) {
        top_g = std::max(top_g, transient.amplitude_g);
    }
    const float part_y = std::round(area.max.y - kFrequencyShare * area.height());
    const Axis time{view.start_s, view.end_s};
    const Rect above{area.min, {area.max.x, part_y - theme.gap_px}};
    const Rect below{{area.min.x, part_y}, area.max};
    StripScale scale{plot_within(above, theme, time, {0.0, kOverhead * top_g}, {"", ""}),
                     plot_within(below, theme, time, frequency_axis(pattern), {"s", ""})};
    scale.note_px = kNotePx * theme.scale;
    scale.tool = tool;
    // One time axis: both lanes begin right of the widest label.
    const float left = area.min.x + text_size(theme.fonts.small, "1000 Hz").x + theme.gap_px;
    for (Plot* lane : {&scale.amplitude, &scale.frequency}) {
        lane->area.min.x = lane->x.low_px = left;
    }
    if (tool == StripTool::notes) {
        const float top = to_pixel(scale.amplitude.y, pattern.amplitude_g);
        scale.note_px = std::max(2.0F * scale.note_px, scale.amplitude.area.max.y - top);
    }
    return scale;
}

namespace {

// The points in view; empty if there are too many to tell apart.
template <class Point>
std::vector<std::size_t> singles_in_view(const std::vector<Point>& all, const Axis& time) {
    const auto is_seen = [&](const Point& point) {
        return point.time_s >= time.low && point.time_s <= time.high;
    };
    if (std::ranges::count_if(all, is_seen) > kMostGrips) return {};
    std::vector<std::size_t> seen;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (is_seen(all[k])) seen.push_back(k);
    }
    return seen;
}

}  // namespace

std::vector<PlacedGrip> placed_grips(const Pattern& pattern, const StripScale& scale) {
    std::vector<PlacedGrip> placed;
    const auto place = [&](GripKind kind, std::size_t index, const Plot& lane, double t_s,
                           double value) {
        if (t_s < lane.x.low || t_s > lane.x.high) return;
        placed.push_back({{kind, index}, {to_pixel(lane.x, t_s), to_pixel(lane.y, value)}});
    };
    const Note note = first_note(pattern);
    const double ramps_s = pattern.attack_s + pattern.release_s;
    const double fit = ramps_s > note.length_s ? note.length_s / ramps_s : 1.0;
    const double attacked_s = note.onset_s + fit * pattern.attack_s;
    const double released_s = note.onset_s + note.length_s - fit * pattern.release_s;
    place(GripKind::attack, 0, scale.amplitude, attacked_s, line_g(pattern, attacked_s));
    place(GripKind::release, 0, scale.amplitude, released_s, line_g(pattern, released_s));
    for (const std::size_t k : singles_in_view(pattern.transients, scale.amplitude.x)) {
        const Transient& transient = pattern.transients[k];
        place(GripKind::transient, k, scale.amplitude, transient.time_s, transient.amplitude_g);
    }
    for (const std::size_t k : singles_in_view(pattern.amplitude_curve, scale.amplitude.x)) {
        const AmplitudePoint& point = pattern.amplitude_curve[k];
        place(GripKind::amplitude_point, k, scale.amplitude, point.time_s,
              point.value * pattern.amplitude_g);
    }
    for (const std::size_t k : singles_in_view(pattern.frequency_curve, scale.amplitude.x)) {
        const FrequencyPoint& point = pattern.frequency_curve[k];
        place(GripKind::frequency_point, k, scale.frequency, point.time_s, point.frequency_hz);
    }
    return placed;
}

std::optional<Grip> grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                            float reach_px) {
    const bool all = scale.tool == StripTool::curves;
    std::optional<Grip> found;
    for (const PlacedGrip& placed : placed_grips(pattern, scale)) {
        const bool is_tick = placed.grip.kind == GripKind::transient;
        if (!all && !(is_tick && scale.tool == StripTool::ticks)) continue;
        const ImVec2 off = placed.at - mouse;
        if (std::hypot(off.x, off.y) <= reach_px) found = placed.grip;
    }
    if (found) return found;
    if (scale.tool != StripTool::ticks) {
        if (const auto note = note_grip_at(pattern, scale, mouse, reach_px)) return note;
    }
    const float end_px = to_pixel(scale.amplitude.x, pattern.duration_s);
    const bool in_lane = scale.amplitude.outer.contains(mouse);
    if (in_lane && std::abs(mouse.x - end_px) <= reach_px) return Grip{GripKind::end};
    if (!all) return std::nullopt;
    const auto on_line = [&](const Plot& lane, double value) {
        return lane.area.contains(mouse) && std::abs(mouse.y - to_pixel(lane.y, value)) <= reach_px;
    };
    const double t_s = to_value(scale.amplitude.x, mouse.x);
    if (on_line(scale.amplitude, line_g(pattern, t_s))) return Grip{GripKind::level};
    if (on_line(scale.frequency, first_carrier_hz(pattern, t_s))) return Grip{GripKind::frequency};
    return std::nullopt;
}

Pattern dragged(const Pattern& before, const Grip& grip, const StripScale& scale,
                const GripDrag& drag) {
    const bool below = grip.kind == GripKind::frequency || grip.kind == GripKind::frequency_point;
    const Step step = step_of(below ? scale.frequency : scale.amplitude, drag);
    const auto ramp = [&](double ramp_s) {
        return std::max(0.0, snapped(ramp_s, kSnapS, drag.free));
    };
    Pattern pattern = before;
    switch (grip.kind) {
        case GripKind::level:
            drag_level(pattern, step, drag.free);
            break;
        case GripKind::frequency:
            drag_frequency(pattern, step, drag.free);
            break;
        case GripKind::amplitude_point:
            drag_amplitude_point(pattern, grip.index, step, drag.free);
            break;
        case GripKind::frequency_point:
            drag_frequency_point(pattern, grip.index, step, drag.free);
            break;
        case GripKind::transient:
            drag_transient(pattern.transients[grip.index], pattern.duration_s, step, drag.free);
            break;
        case GripKind::attack:
            pattern.attack_s = ramp(pattern.attack_s + step.time_s);
            break;
        case GripKind::release:
            pattern.release_s = ramp(pattern.release_s - step.time_s);
            break;
        case GripKind::note_start:
        case GripKind::note:
        case GripKind::note_end:
            pattern.rhythm =
                with_note_dragged(pattern.rhythm, grip, time_dragged_s(scale, drag), snap_of(drag));
            break;
        case GripKind::note_top:
            pattern.rhythm = with_note_strength(pattern.rhythm, grip, strength_at(scale, drag.to));
            break;
        case GripKind::end:
            pattern =
                with_duration(before, snapped(before.duration_s + step.time_s, kSnapS, drag.free));
            break;
    }
    return clamped(std::move(pattern));
}

bool is_shared(GripKind kind, const Pattern& pattern) {
    if (kind == GripKind::frequency) return pattern.frequency_curve.empty();
    return !is_single(kind);
}

void copy_change(GripKind kind, const Pattern& from, Pattern& to) {
    if (kind == GripKind::attack) to.attack_s = from.attack_s;
    if (kind == GripKind::release) to.release_s = from.release_s;
    if (kind == GripKind::end) to = with_duration(to, from.duration_s);
    if (kind == GripKind::level) to.amplitude_g = from.amplitude_g;
    if (kind == GripKind::frequency) to.carriers[0].frequency_hz = from.carriers[0].frequency_hz;
    if (is_note(kind)) to.rhythm = from.rhythm;
}

std::optional<Grip> add_point(Pattern& pattern, GripKind line, double time_s) {
    const double t_s = std::clamp(snapped(time_s, kSnapS, false), 0.0, pattern.duration_s);
    std::optional<std::size_t> place;
    if (line == GripKind::level) {
        AmplitudeCurve& curve = pattern.amplitude_curve;
        place = with_ends(curve, t_s, pattern.duration_s,
                          [&](double at_s) { return insert_point(curve, at_s); });
        if (place) return Grip{GripKind::amplitude_point, *place};
    } else if (line == GripKind::frequency) {
        FrequencyCurve& curve = pattern.frequency_curve;
        const double hz = pattern.carriers[0].frequency_hz;
        place = with_ends(curve, t_s, pattern.duration_s,
                          [&](double at_s) { return insert_point(curve, at_s, hz); });
        if (place) return Grip{GripKind::frequency_point, *place};
    }
    return std::nullopt;
}

std::optional<Grip> add_transient(Pattern& pattern, double time_s, double amplitude_g) {
    if (pattern.transients.size() >= limits::kMaxTransients) return std::nullopt;
    Transient transient;
    transient.time_s = std::clamp(snapped(time_s, kSnapS, false), 0.0, pattern.duration_s);
    transient.amplitude_g =
        std::clamp(snapped(amplitude_g, kSnapG, false), 0.0, limits::kAmplitudeG.high);
    transient.frequency_hz = first_carrier_hz(pattern, transient.time_s);
    pattern.transients.push_back(transient);
    return Grip{GripKind::transient, pattern.transients.size() - 1};
}

std::optional<Grip> next_single(const Pattern& pattern, std::optional<Grip> from, int step) {
    std::vector<std::pair<double, Grip>> all;
    const auto add = [&all](GripKind kind, const auto& points) {
        for (std::size_t k = 0; k < points.size(); ++k)
            all.push_back({points[k].time_s, {kind, k}});
    };
    add(GripKind::amplitude_point, pattern.amplitude_curve);
    add(GripKind::transient, pattern.transients);
    add(GripKind::frequency_point, pattern.frequency_curve);
    if (all.empty()) return std::nullopt;
    std::ranges::stable_sort(all, {}, &std::pair<double, Grip>::first);
    const auto found =
        std::ranges::find(all, from, [](const auto& one) { return std::optional(one.second); });
    const std::size_t last = all.size() - 1;
    if (found == all.end()) return all[step < 0 ? last : 0].second;
    const auto at = static_cast<std::size_t>(found - all.begin());
    if (step < 0) return all[at == 0 ? last : at - 1].second;
    return all[at == last ? 0 : at + 1].second;
}

void remove(Pattern& pattern, const Grip& grip) {
    if (!exists(pattern, grip)) return;
    const auto erase = [&](auto& list) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(grip.index));
    };
    if (grip.kind == GripKind::amplitude_point) erase(pattern.amplitude_curve);
    if (grip.kind == GripKind::frequency_point) erase(pattern.frequency_curve);
    if (grip.kind == GripKind::transient) erase(pattern.transients);
}

bool exists(const Pattern& pattern, const Grip& grip) {
    if (is_note(grip.kind)) {
        return grip.index < notes(pattern.rhythm, pattern.duration_s).size();
    }
    switch (grip.kind) {
        case GripKind::amplitude_point:
            return grip.index < pattern.amplitude_curve.size();
        case GripKind::frequency_point:
            return grip.index < pattern.frequency_curve.size();
        case GripKind::transient:
            return grip.index < pattern.transients.size();
        default:
            return true;
    }
}

}  // namespace tact
