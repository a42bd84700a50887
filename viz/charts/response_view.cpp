#include "viz/charts/response_view.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kMarkPx = 3.0F;
constexpr float kKnotReachPx = 12.0F;
constexpr double kRoom = 1.4;  // factor above the largest and below the smallest value

// The range of all drawn points, with some room.
Axis spanned(const ResponseScene& scene, double ResponseMark::*value, double room) {
    Axis axis{INFINITY, 0.0, Scale::logarithmic};
    for (const auto& marks : {scene.table, scene.refused}) {
        for (const ResponseMark& mark : marks) {
            if (!(mark.*value > 0.0)) continue;
            axis.low = std::min(axis.low, mark.*value);
            axis.high = std::max(axis.high, mark.*value);
        }
    }
    if (!(axis.high > 0.0)) return {0.1, 10.0, Scale::logarithmic};
    axis.low /= room;
    axis.high *= room;
    return axis;
}

ImVec2 place_of(const Plot& plot, const ResponseMark& mark) {
    return {to_pixel(plot.x, mark.frequency_hz), to_pixel(plot.y, mark.g)};
}

}  // namespace

ResponseAction draw_response(const char* id, const Theme& theme, const Rect& area,
                             const ResponseScene& scene) {
    ResponseAction action;
    if (area.empty()) return action;
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, area.size());
    const PlotLabels labels{"Hz", "g"};
    const Plot plot = plot_within(area, theme, spanned(scene, &ResponseMark::frequency_hz, 1.1),
                                  spanned(scene, &ResponseMark::g, kRoom), labels);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, theme, plot, labels);
    const float radius = kMarkPx * theme.scale;
    for (const ResponseMark& mark : scene.refused) {
        if (!(mark.g > 0.0)) continue;
        list.AddCircle(place_of(plot, mark), radius, theme.warning, 0, theme.trace_px);
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    float nearest = kKnotReachPx * theme.scale;
    for (std::size_t k = 0; k < scene.table.size(); ++k) {
        const ImVec2 at = place_of(plot, scene.table[k]);
        if (k > 0) {
            list.AddLine(place_of(plot, scene.table[k - 1]), at, theme.series, theme.trace_px);
        }
        list.AddCircleFilled(at, radius, theme.series);
        const float away = std::abs(at.x - mouse.x);
        if (!ImGui::IsItemHovered() || away >= nearest) continue;
        nearest = away;
        action.hovered = k;
    }
    if (action.hovered) {
        list.AddCircle(place_of(plot, scene.table[*action.hovered]), 2.0F * radius, theme.text, 0,
                       theme.trace_px);
    }
    return action;
}

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

namespace {

// The curve under the mouse, within a few pixels.
std::optional<Receptor> curve_at(const Theme& theme, const Plot& plot, const SpectrumScene& scene,
                                 ImVec2 at) {
    std::optional<Receptor> best;
    float least = 7.0F * theme.scale;
    for (const Receptor receptor : kReceptors) {
        const Curve& curve = (*scene.thresholds)[index_of(receptor)];
        const double db = threshold_db(curve, to_value(plot.x, at.x));
        const float away = std::abs(to_pixel(plot.y, db) - at.y);
        if (away >= least) continue;
        least = away;
        best = receptor;
    }
    return best;
}

}  // namespace

double threshold_db(const Curve& threshold, double frequency_hz) {
    return 20.0 * at(threshold, frequency_hz);
}

void draw_threshold(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                    const Curve& threshold, ImU32 colour) {
    draw_over_frequency(
        list, theme, plot, receptor,
        [&threshold](double frequency_hz) { return threshold_db(threshold, frequency_hz); },
        colour);
}

void draw_ghosts(ImDrawList& list, const Theme& theme, const Plot& plot,
                 const SpectrumScene& scene) {
    if (scene.ghosts == nullptr) return;
    for (const Receptor receptor : kReceptors) {
        const std::size_t i = index_of(receptor);
        const Curve& was = (*scene.ghosts)[i];
        if (was == (*scene.thresholds)[i]) continue;
        draw_threshold(list, theme, plot, receptor, was, faded(theme.receptor[i], 0.28F));
    }
}

void draw_tick_of_peak(ImDrawList& list, const Theme& theme, const Plot& plot) {
    constexpr double kPeakHz = 250.0;
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const float x = to_pixel(plot.x, kPeakHz);
    const std::string text = tick_text(kPeakHz);
    const float half_px = 0.5F * text_size(font, text).x;
    const std::vector<double> ticks = ticks_apart(plot.x, 4.0F * text_px);
    for (const double tick : ticks) {
        const bool last = tick == ticks.back();
        const float reach_px = half_px + (last ? 3.0F : 1.2F) * text_px;
        if (std::abs(to_pixel(plot.x, tick) - x) < reach_px) return;
    }
    draw_upright_line(list, x, plot.area.max.y, plot.area.max.y + 3.0F * theme.scale,
                      theme.hairline_px, theme.line);
    draw_text(list, font, {x - half_px, plot.area.max.y + 5.0F * theme.scale}, theme.dim_text,
              text);
}

void draw_measured(ImDrawList& list, const Theme& theme, const Plot& plot,
                   const SpectrumScene& scene) {
    constexpr float kLeastPx = 140.0F;  // share of a plot at whose bottom bars hide no curve
    const float bar_px = 3.0F * theme.scale;
    float bottom = plot.area.max.y - bar_px;
    for (const MeasuredBand& band : scene.bands) {
        if (plot.area.height() < kLeastPx * theme.scale) break;
        const float left = to_pixel(plot.x, std::max(band.hz.low, plot.x.low));
        const float right = to_pixel(plot.x, std::min(band.hz.high, plot.x.high));
        list.AddRectFilled({left, bottom - bar_px}, {right, bottom}, faded(theme.dim_text, 0.55F));
        draw_receptor_mark(list, theme, {left + theme.mark_px, bottom - 0.5F * bar_px},
                           0.8F * theme.mark_px, band.receptor);
        bottom -= 3.0F * bar_px;
    }
    const auto at = [&](const std::pair<double, double>& point) {
        return ImVec2{to_pixel(plot.x, point.first), to_pixel(plot.y, point.second)};
    };
    for (std::size_t k = 0; k < scene.felt_db.size(); ++k) {
        if (k > 0) {
            list.AddLine(at(scene.felt_db[k - 1]), at(scene.felt_db[k]), faded(theme.text, 0.4F),
                         theme.hairline_px);
        }
        list.AddCircle(at(scene.felt_db[k]), 0.8F * theme.mark_px, theme.text, 0,
                       1.5F * theme.hairline_px);
    }
}

// The held one, kept between frames: 0 none, otherwise its index plus one.
void take_curve(const char* id, const Theme& theme, const Plot& plot, const SpectrumScene& scene,
                SpectrumAction& action) {
    int& held = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID(id), 0);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!scene.curves_move) return;
    const std::optional<Receptor> near = curve_at(theme, plot, scene, mouse);
    if (ImGui::IsItemHovered() && plot.area.contains(mouse) && near) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    }
    if (ImGui::IsItemActivated()) held = near ? static_cast<int>(index_of(*near)) + 1 : 0;
    if (held == 0) return;
    action.taken = kReceptors[static_cast<std::size_t>(held - 1)];
    action.moved_db =
        to_value(plot.y, mouse.y) - to_value(plot.y, mouse.y - ImGui::GetIO().MouseDelta.y);
    action.released = ImGui::IsItemDeactivated();
    if (ImGui::IsItemActivated() || action.released) action.moved_db = 0.0;
    if (action.released) held = 0;
}

}  // namespace tact
