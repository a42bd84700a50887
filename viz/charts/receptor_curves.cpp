#include "viz/charts/receptor_curves.h"

#include <cmath>
#include <vector>

#include "viz/drawing/marks.h"

namespace tact {

namespace {

bool is_in_band(Receptor receptor, double frequency_hz) {
    return frequency_hz >= traits(receptor).low_hz && frequency_hz <= traits(receptor).high_hz;
}

}  // namespace

void draw_over_frequency(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                         const std::function<double(double)>& value, ImU32 colour) {
    constexpr float kStepPx = 2.0F;
    const float dash_px = 5.0F * theme.scale;
    std::vector<ImVec2> points;
    const auto end_line = [&] {
        if (points.size() > 1) {
            list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0,
                             theme.trace_px);
        }
        points.clear();
    };
    for (float x = plot.area.min.x; x < plot.area.max.x + kStepPx; x += kStepPx) {
        const double frequency_hz = to_value(plot.x, x);
        points.push_back({x, to_pixel(plot.y, value(frequency_hz))});
        const bool in_gap = std::fmod(x - plot.area.min.x, 2.0F * dash_px) >= dash_px;
        if (in_gap && !is_in_band(receptor, frequency_hz)) end_line();
    }
    end_line();
}

void draw_receptor_curves(const Theme& theme, const Rect& area, const ReceptorCurves& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PlotLabels labels{.x_unit = "Hz", .y_unit = scene.unit};
    const Plot plot = plot_within(
        area, theme, {scene.frequency_hz.low, scene.frequency_hz.high, Scale::logarithmic},
        {scene.values.low, scene.values.high}, labels);
    draw_axes(list, theme, plot, labels);
    for (const Receptor receptor : kReceptors) {
        const std::size_t k = index_of(receptor);
        const Curve& curve = (*scene.curves)[k];
        draw_over_frequency(
            list, theme, plot, receptor,
            [&curve](double frequency_hz) { return at(curve, frequency_hz); }, theme.receptor[k]);
        // A mark on each knot: tables hold the knots, the rest is interpolated.
        for (const double frequency_hz : curve.frequency_hz) {
            if (!scene.frequency_hz.contains(frequency_hz)) continue;
            draw_receptor_mark(
                list, theme,
                {to_pixel(plot.x, frequency_hz), to_pixel(plot.y, at(curve, frequency_hz))},
                0.5F * theme.mark_px, receptor);
        }
    }
}

}  // namespace tact
