#include "app/wave_strip/wave_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/wave_strip/parts.h"
#include "model/pattern/rhythm_edit.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kGripPx = 4.0F;  // radius

// The upper half of the wave, as the axis begins at 0.
void draw_body(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    if (scene.waveform == nullptr) return;
    const Plot& lane = scene.scale.amplitude;
    list.PushClipRect(lane.area.min, lane.area.max, true);
    draw_signal(list, theme, lane, scene.waveform->samples_g, scene.waveform->rate_hz,
                faded(scene.colour, 0.6F), TraceStyle::line);
    list.PopClipRect();
}

// Another vibration's wave below, dim, and its name at the end of the pattern.
void draw_ghost(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    if (scene.ghost == nullptr) return;
    const Plot& lane = scene.scale.amplitude;
    list.PushClipRect(lane.area.min, lane.area.max, true);
    draw_signal(list, theme, lane, scene.ghost->samples_g, scene.ghost->rate_hz,
                faded(theme.dim_text, 0.5F), TraceStyle::line);
    list.PopClipRect();
}

void draw_ghost_words(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    if (scene.ghost == nullptr) return;
    const Rect& lane = scene.scale.amplitude.area;
    const ImFont* font = theme.fonts.small;
    const float line_px = text_size(font, "0").y;
    if (lane.height() < 3.0F * line_px) return;
    const std::string words = shortened(font, scene.ghost_words, 0.6F * lane.width());
    const float end_px = to_pixel(scene.scale.amplitude.x, scene.pattern.duration_s);
    const ImVec2 at{std::min(lane.max.x, end_px) - text_size(font, words).x - 0.5F * theme.gap_px,
                    lane.min.y + line_px};
    const float halo_px = 2.0F * theme.scale;
    if (at.y + line_px + halo_px > list.GetClipRectMax().y) return;  // half a name says nothing
    draw_text_halo(list, font, at, theme.dim_text, theme.pane, halo_px, words);
}

// A line at the beginning of each bar, unless they are too close to tell apart.
void draw_bars(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    const Rhythm& rhythm = scene.pattern.rhythm;
    const double bar_s = rhythm.unit_s * static_cast<double>(steps_a_bar(rhythm.meter));
    if (rhythm.text.empty() || bar_s <= 0.0) return;
    constexpr float kLeastPx = 12.0F;
    const Plot& lane = scene.scale.amplitude;
    const float bar_px = to_pixel(lane.x, bar_s) - to_pixel(lane.x, 0.0);
    if (bar_px < kLeastPx * theme.scale) return;
    const double first = std::max(1.0, std::ceil(to_value(lane.x, lane.area.min.x) / bar_s));
    for (double k = first; k * bar_s < scene.pattern.duration_s; k += 1.0) {
        const float x = to_pixel(lane.x, k * bar_s);
        if (x > lane.area.max.x) break;
        draw_upright_line(list, x, lane.area.min.y, lane.area.max.y, theme.hairline_px,
                          faded(theme.dim_text, 0.6F));
    }
}

// A row of blocks; with the tool of notes they are as high as they are strong, with a bar to drag.
// Thousands of blocks narrower than a bar are drawn as the highest in each column of pixels.
void draw_notes(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    constexpr float kNarrowPx = 4.0F;
    const Rect& lane = scene.scale.amplitude.area;
    const bool is_high = scene.scale.tool == StripTool::notes;
    const bool some_chosen = !scene.notes.empty();
    const std::vector<NoteSteps> steps =
        some_chosen ? steps_of_notes(scene.pattern) : std::vector<NoteSteps>{};
    const float bar_px = 3.0F * theme.scale;
    const float rounding = 2.0F * theme.scale;
    list.PushClipRect(lane.min, lane.max, true);
    float last_px = -1.0F;  // the column drawn last, and its height
    float last_top = 0.0F;
    for (const auto& [index, area, top] : note_blocks(scene.pattern, scene.scale)) {
        const bool chosen =
            some_chosen && std::ranges::binary_search(scene.notes.onsets, steps[index].first);
        const bool lit =
            chosen || (scene.under && is_note(scene.under->kind) && scene.under->index == index);
        const ImVec2 max{std::max(area.max.x - theme.hairline_px, area.min.x + 1.0F), area.max.y};
        const ImU32 ink = lit ? theme.text : theme.dim_text;
        if (!is_high) {
            list.AddRectFilled({area.min.x, top}, max, ink, rounding);
            continue;
        }
        if (area.width() < kNarrowPx * theme.scale) {
            const float column = std::floor(area.min.x);
            if (column == last_px && top >= last_top && !lit) continue;
            last_px = column;
            last_top = top;
            list.AddRectFilled({area.min.x, top}, max, faded(scene.colour, lit ? 0.8F : 0.5F));
            continue;
        }
        list.AddRectFilled({area.min.x, top}, max, faded(scene.colour, lit ? 0.5F : 0.32F),
                           rounding);
        list.AddRect({area.min.x, top}, max, chosen ? theme.text : scene.colour, rounding, 0,
                     (chosen ? 2.0F : 1.0F) * theme.hairline_px);
        list.AddRectFilled({area.min.x, top}, {max.x, top + bar_px}, ink, rounding);
    }
    list.PopClipRect();
}

// The notes that a copy takes, and the box that chooses notes.
void draw_span(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    const Plot& lane = scene.scale.amplitude;
    const auto draw = [&](float from, float to) {
        const auto [left, right] = std::minmax(std::clamp(from, lane.area.min.x, lane.area.max.x),
                                               std::clamp(to, lane.area.min.x, lane.area.max.x));
        if (right <= left) return;
        list.AddRectFilled({left, lane.area.min.y}, {right, lane.area.max.y},
                           faded(theme.accent, 0.16F));
        for (const float x : {left, right}) {
            draw_upright_line(list, x, lane.area.min.y, lane.area.max.y, theme.hairline_px,
                              theme.accent);
        }
    };
    if (scene.box) return draw(scene.box->from_px, scene.box->to_px);
    if (scene.notes.empty()) return;
    const double unit_s = scene.pattern.rhythm.unit_s;
    draw(to_pixel(lane.x, static_cast<double>(scene.notes.span.first) * unit_s),
         to_pixel(lane.x, static_cast<double>(scene.notes.span.last + 1) * unit_s));
}

// The same path with at most four points in each column of pixels.
std::vector<ImVec2> by_columns(const std::vector<ImVec2>& points) {
    std::vector<ImVec2> path;
    for (std::size_t k = 0; k < points.size();) {
        const float column = std::floor(points[k].x);
        std::size_t end = k;
        while (end < points.size() && std::floor(points[end].x) == column) ++end;
        const std::span<const ImVec2> here(points.data() + k, end - k);
        const auto [high, low] = std::ranges::minmax_element(here, {}, &ImVec2::y);
        if (here.size() > 4) {
            path.insert(path.end(), {here.front(), *high, *low, here.back()});
        } else {
            path.insert(path.end(), here.begin(), here.end());
        }
        k = end;
    }
    return path;
}

// The curve of each lane, constant before its first and after its last point.
void draw_lines(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    const Pattern& pattern = scene.pattern;
    const auto draw = [&](const Plot& lane, GripKind line, const std::vector<ImVec2>& points) {
        const bool lit = scene.under && scene.under->kind == line;
        list.PushClipRect(lane.area.min, lane.area.max, true);
        draw_path(list, by_columns(points), theme.text, (lit ? 2.0F : 1.0F) * theme.trace_px);
        list.PopClipRect();
    };
    std::vector<ImVec2> points;
    const Plot& above = scene.scale.amplitude;
    const auto add = [&](double t_s, double factor) {
        points.push_back({to_pixel(above.x, t_s), to_pixel(above.y, pattern.amplitude_g * factor)});
    };
    add(0.0, pattern.amplitude_curve.empty() ? 1.0 : pattern.amplitude_curve.front().value);
    for (const AmplitudePoint& point : pattern.amplitude_curve) add(point.time_s, point.value);
    add(pattern.duration_s,
        pattern.amplitude_curve.empty() ? 1.0 : pattern.amplitude_curve.back().value);
    draw(above, GripKind::level, points);
    // A straight line in Hz is bent on a logarithmic axis.
    points.clear();
    const Plot& below = scene.scale.frequency;
    const FrequencyCurve curve = sounding_frequency(pattern);
    const double steady_hz = pattern.carriers.front().frequency_hz;
    const float left = std::max(to_pixel(below.x, 0.0), below.area.min.x);
    const float right = std::min(to_pixel(below.x, pattern.duration_s), below.area.max.x);
    for (float x = left; x < right + 1.0F; x += 1.0F) {
        const float at = std::min(x, right);
        const double hz = frequency_at(curve, to_value(below.x, at)).value_or(steady_hz);
        points.push_back({at, to_pixel(below.y, hz)});
    }
    draw(below, GripKind::frequency, points);
}

void draw_grips(ImDrawList& list, const Theme& theme, const StripScene& scene) {
    const Plot& lane = scene.scale.amplitude;
    for (const PlacedGrip& placed : placed_grips(scene.pattern, scene.scale)) {
        const bool lit = scene.under == placed.grip;
        const bool chosen = scene.chosen == placed.grip;
        const float radius = (lit || chosen ? 1.4F : 1.0F) * kGripPx * theme.scale;
        // Grips of other tools are not offered.
        const bool is_tick = placed.grip.kind == GripKind::transient;
        if (!is_tick && scene.scale.tool != StripTool::curves) continue;
        const bool ramp =
            placed.grip.kind == GripKind::attack || placed.grip.kind == GripKind::release;
        if (is_tick) {
            draw_upright_line(list, placed.at.x, placed.at.y, lane.area.max.y, theme.trace_px,
                              scene.colour);
        }
        if (ramp) {
            const float r = radius * 1.2F;
            list.AddQuadFilled(placed.at - ImVec2{r, 0}, placed.at - ImVec2{0, r},
                               placed.at + ImVec2{r, 0}, placed.at + ImVec2{0, r}, theme.dim_text);
            continue;
        }
        if (chosen) {
            draw_disc(list, theme, placed.at, radius + 3.0F * theme.scale, theme.text);
            draw_disc(list, theme, placed.at, radius + 1.5F * theme.scale, theme.pane);
        }
        draw_disc(list, theme, placed.at, radius, chosen || lit ? theme.text : scene.colour);
    }
    const bool end_lit = scene.under && scene.under->kind == GripKind::end;
    const float end_px = to_pixel(lane.x, scene.pattern.duration_s);
    if (end_px > lane.area.max.x) return;
    draw_upright_line(list, end_px, lane.area.min.y, scene.scale.frequency.area.max.y,
                      (end_lit ? 3.0F : 1.0F) * theme.hairline_px,
                      end_lit ? theme.text : theme.dim_text);
}

std::string reading(const Pattern& pattern, const Grip& grip) {
    const auto at = [](double t_s) { return significant(1000.0 * t_s) + " ms"; };
    switch (grip.kind) {
        case GripKind::level:
            return significant(pattern.amplitude_g) + " g";
        case GripKind::frequency:
            return significant(pattern.carriers[0].frequency_hz) + " Hz";
        case GripKind::amplitude_point: {
            const AmplitudePoint& point = pattern.amplitude_curve[grip.index];
            return at(point.time_s) + ", " + significant(point.value * pattern.amplitude_g) + " g";
        }
        case GripKind::frequency_point: {
            const FrequencyPoint& point = pattern.frequency_curve[grip.index];
            return at(point.time_s) + ", " + significant(point.frequency_hz) + " Hz";
        }
        case GripKind::transient: {
            const Transient& transient = pattern.transients[grip.index];
            return at(transient.time_s) + ", " + significant(transient.amplitude_g) + " g, " +
                   significant(transient.frequency_hz) + " Hz";
        }
        case GripKind::attack:
            return at(pattern.attack_s);
        case GripKind::release:
            return at(pattern.release_s);
        case GripKind::note_start:
        case GripKind::note:
        case GripKind::note_end:
        case GripKind::note_top: {
            const Note note = notes(pattern.rhythm, pattern.duration_s)[grip.index];
            const std::string times = at(note.onset_s) + " to " + at(note.onset_s + note.length_s);
            std::string words = times;
            if (note.velocity < 1.0) {
                words += ", strength " + exact_percent(note.velocity);
            }
            if (note.pitch != 1.0) words += ", pitch " + significant(note.pitch) + " x";
            return words;
        }
        case GripKind::end:
            return significant(pattern.duration_s) + " s";
    }
    return {};
}

// The item under the mouse, and the effect of a press.
void draw_help(ImDrawList& list, const Theme& theme, const Rect& area, const StripScene& scene) {
    if (!scene.hovered) return;
    std::string text = help_on(scene.scale.tool);
    if (scene.is_ruler_hovered) text = "Drag: the playhead. Double click or 0: the whole pattern.";
    if (scene.under && exists(scene.pattern, *scene.under)) {
        text = reading(scene.pattern, *scene.under) + "   " + help_on(scene.under->kind);
    }
    const float left = scene.scale.amplitude.area.min.x + 0.5F * theme.gap_px;
    draw_text_halo(list, theme.fonts.small, {left, area.min.y}, theme.dim_text, theme.pane,
                   2.0F * theme.scale, shortened(theme.fonts.small, text, area.max.x - left));
}

// The axis of a lane, with its unit at the highest number. A lane too low for two round numbers
// shows its own numbers instead: a single round number beside a line would be read as that line's
// value.
void draw_lane_axis(ImDrawList& list, const Theme& theme, const Plot& lane, std::string_view unit,
                    std::span<const double> shown) {
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const std::vector<double> round = ticks_apart(lane.y, 1.4F * text_px);
    const auto above = std::ranges::find_if(round, [&](double tick) { return tick > lane.y.low; });
    const bool has_two = round.end() - above > 1 && std::abs(to_pixel(lane.y, round.back()) -
                                                             to_pixel(lane.y, *above)) >= text_px;
    std::vector<double> ticks(shown.begin(), shown.end());
    if (has_two) ticks = round;
    std::ranges::sort(ticks, std::greater());
    const float right = lane.area.min.x - 0.75F * theme.gap_px;
    std::optional<float> last;
    for (const double tick : ticks) {
        const float y = to_pixel(lane.y, tick);
        if (last && std::abs(*last - y) < text_px) continue;
        draw_level_line(list, y, lane.area.min.x, lane.area.max.x, theme.hairline_px,
                        faded(theme.line, 0.7F));
        std::string text = significant_digits(tick, 3);
        if (!last) text += " " + std::string(unit);
        const float left = std::max(lane.outer.min.x, right - text_size(font, text).x);
        draw_text(list, font, {left, y - 0.55F * text_px}, theme.dim_text, text);
        last = y;
    }
}

}  // namespace

void draw_strip_picture(ImDrawList& list, const Theme& theme, const Rect& area,
                        const StripScene& scene) {
    const double peak_g = scene.scale.amplitude.y.high / kOverhead;
    draw_lane_axis(list, theme, scene.scale.amplitude, "g", std::array{0.0, peak_g});
    const Range hz = carrier_range_hz(scene.pattern);
    draw_lane_axis(list, theme, scene.scale.frequency, "Hz", std::array{hz.low, hz.high});
    draw_axes(list, theme, scene.scale.frequency, {"s", "", false});
    draw_ghost(list, theme, scene);
    draw_body(list, theme, scene);
    draw_bars(list, theme, scene);
    draw_span(list, theme, scene);
    draw_notes(list, theme, scene);
    draw_lines(list, theme, scene);
    if (scene.playhead_s) {
        for (const Plot* lane : {&scene.scale.amplitude, &scene.scale.frequency}) {
            draw_cursor_line(list, theme, *lane, *scene.playhead_s, theme.accent);
        }
    }
    list.PushClipRect(area.min, area.max, true);
    draw_grips(list, theme, scene);
    draw_ghost_words(list, theme, scene);
    draw_help(list, theme, area, scene);
    list.PopClipRect();
}

}  // namespace tact
