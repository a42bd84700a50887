#include "viz/charts/threshold_curves.h"

#include <cmath>
#include <string>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {
namespace {

bool is_in_band(Receptor receptor, double frequency_hz) {
    return frequency_hz >= traits(receptor).low_hz && frequency_hz <= traits(receptor).high_hz;
}

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
        points.push_back({x, to_pixel(plot.y, threshold_db(threshold, frequency_hz))});
        const bool in_gap = std::fmod(x - plot.area.min.x, 2.0F * dash_px) >= dash_px;
        if (in_gap && !is_in_band(receptor, frequency_hz)) end_line();
    }
    end_line();
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

// Which one is held outlives the frame: 0 none, else its place and one.
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
