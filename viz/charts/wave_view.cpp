#include "viz/charts/wave_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {
namespace {

Plot plot_of(const Theme& theme, const Rect& area, const WaveScene& scene,
             const PlotLabels& labels) {
    // 5 % of room, so that peaks do not touch the neighbour.
    const double reach = 1.05 * (scene.largest > 0.0 ? scene.largest : largest_value(scene.traces));
    const Axis time{.low = scene.start_s, .high = scene.end_s};
    const Axis value{.low = scene.signed_values ? -reach : 0.0, .high = reach};
    Plot plot = plot_within(area, theme, time, value, labels);
    plot.area.min.x = std::max(plot.area.min.x, area.min.x + scene.left_room_px);
    plot.x.low_px = plot.area.min.x;
    return plot;
}

void draw_value_at(ImDrawList& list, const Theme& theme, const Plot& plot, const WaveScene& scene,
                   double time_s, std::size_t sample, ImVec2 mouse_px) {
    const WaveTrace& trace = scene.traces.back();
    const double value = trace.samples[sample];
    const ImVec2 at{to_pixel(plot.x, time_s), to_pixel(plot.y, value)};
    draw_disc(list, theme, at, 3.5F * theme.scale, theme.pane);
    draw_disc(list, theme, at, 2.5F * theme.scale, trace.colour);
    const std::array<std::string, 2> lines{
        significant(value) + (scene.unit.empty() ? "" : " " + std::string{scene.unit}),
        place_text(plot.x, time_s) + " s"};
    draw_readout(list, theme, plot.area, mouse_px, lines);
}

// The sample of the last trace at a time.
std::optional<std::size_t> sample_at(const WaveScene& scene, double time_s) {
    if (scene.traces.empty()) return std::nullopt;
    const WaveTrace& trace = scene.traces.back();
    const double index = std::floor(time_s * trace.rate_hz);
    if (index < 0.0 || index >= static_cast<double>(trace.samples.size())) return std::nullopt;
    return static_cast<std::size_t>(index);
}

}  // namespace

double largest_value(std::span<const WaveTrace> traces) {
    double largest = 0.0;
    for (const WaveTrace& trace : traces) {
        for (const double sample : trace.samples) largest = std::max(largest, std::abs(sample));
    }
    return largest > 0.0 ? largest : 1.0;
}

WaveAction draw_wave(const char* id, const Theme& theme, const Rect& area, const WaveScene& scene) {
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotLabels labels{
        .x_unit = scene.time_axis ? "s" : "", .y_unit = scene.unit, .y_grid = scene.value_axis};
    const Plot plot = plot_of(theme, area, scene, labels);
    if (plot.area.empty()) return {};
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, area.size());
    const bool hovered = ImGui::IsItemHovered();
    const bool held = ImGui::IsItemActive();

    draw_axes(list, theme, plot, labels);
    draw_zero_line(list, theme, plot);
    for (const WaveTrace& trace : scene.traces) {
        draw_signal(list, theme, plot, trace.samples, trace.rate_hz, trace.colour, trace.style);
    }
    if (scene.stale) draw_stale(list, theme, plot.area, ImGui::GetTime());
    if (scene.crosshair_s) {
        draw_cursor_line(list, theme, plot, *scene.crosshair_s, faded(theme.dim_text, 0.6F));
    }
    if (scene.playhead_s) {
        draw_cursor_line(list, theme, plot, *scene.playhead_s, theme.accent);
    }

    WaveAction action;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (hovered || held) {
        const double time_s = std::clamp(to_value(plot.x, mouse.x), scene.start_s, scene.end_s);
        if (held) action.scrubbed_s = time_s;
        if (hovered && plot.area.contains(mouse)) {
            action.hovered_s = time_s;
            draw_cursor_line(list, theme, plot, time_s, faded(theme.dim_text, 0.6F));
            action.hovered_sample = sample_at(scene, time_s);
            if (action.hovered_sample) {
                draw_value_at(list, theme, plot, scene, time_s, *action.hovered_sample, mouse);
            }
        }
    }
    return action;
}

}  // namespace tact
