#include "app/measured/measured.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/wave_body.h"

namespace tact {

namespace {

constexpr float kFilledInk = 0.7F;
constexpr float kPreviewPx = 170.0F;

// A dashed path: every other few pixels of points that are one pixel apart.
void draw_dashes(ImDrawList& list, const Theme& theme, std::span<const ImVec2> points) {
    const auto dash = static_cast<std::size_t>(std::lround(5.0F * theme.scale));
    for (std::size_t k = 0; k < points.size(); k += 2 * dash) {
        const std::size_t count = std::min(dash + 1, points.size() - k);
        draw_path(list, points.subspan(k, count), theme.text, 2.0F * theme.scale);
    }
}

// Upper and lower envelope of a wave: dashed, so that it stays visible over another wave.
void draw_reach(ImDrawList& list, const Theme& theme, const Plot& plot, const Waveform& wave,
                double least_g) {
    constexpr double kWidestPx = 16.0;  // path of a period whose crests are joined
    const auto columns = static_cast<std::size_t>(std::max(1.0F, plot.area.width()));
    const auto body =
        body_columns(wave.samples_g, plot.x.low * wave.rate_hz, plot.x.high * wave.rate_hz, columns,
                     {kWidestPx * double{theme.scale}, least_g});
    for (const auto edge : {&Extremes::high, &Extremes::low}) {
        std::vector<ImVec2> line;
        for (std::size_t k = 0; k < body.size(); ++k) {
            line.push_back(
                {plot.area.min.x + static_cast<float>(k) + 0.5F, to_pixel(plot.y, body[k].*edge)});
        }
        draw_dashes(list, theme, line);
    }
}

// Names of the two curves above their right end, each with a sample of its line.
void draw_names(const Ui& ui, const Plot& plot, const Overlay& overlay) {
    const Theme& theme = ui.theme;
    const ImFont* font = theme.fonts.small;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float sign_px = 25.0F * theme.scale;
    const float middle = plot.outer.min.y + 0.55F * text_size(font, "x").y;
    float x = plot.area.max.x;
    const auto name = [&](const char* text) {
        x -= text_size(font, text).x;
        draw_text(list, font, {x, plot.outer.min.y}, theme.text, text);
        x -= 0.5F * theme.gap_px + sign_px;
    };
    name(overlay.dashed_name);
    std::vector<ImVec2> sample;
    for (float along = 0.0F; along <= sign_px; along += 1.0F) sample.push_back({x + along, middle});
    draw_dashes(list, theme, sample);
    x -= 2.0F * theme.gap_px;
    name(overlay.filled_name);
    const float half = 3.0F * theme.scale;
    list.AddRectFilled({x, middle - half}, {x + sign_px, middle + half},
                       faded(theme.series, kFilledInk));
}

}  // namespace

void draw_overlay(Ui& ui, const Overlay& overlay) {
    const Theme& theme = ui.theme;
    const float width = ImGui::GetContentRegionAvail().x;
    const Rect outer = rect_at(ImGui::GetCursorScreenPos(), {width, kPreviewPx * theme.scale});
    ImGui::Dummy(outer.size());
    note_rect(ui.rects, overlay.rect, outer.min, outer.max);
    const Waveform& filled = overlay.filled;
    const Waveform& dashed = overlay.dashed;
    const double most = std::max({peak_g(dashed), peak_g(filled), 1e-6});
    const PlotLabels labels{"s", "g"};
    const Plot plot =
        plot_within(outer, theme, {0.0, std::max(duration_s(dashed), 1e-3)}, {-most, most}, labels);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, theme, plot, labels);
    draw_signal(list, theme, plot, filled.samples_g, filled.rate_hz,
                faded(theme.series, kFilledInk), TraceStyle::line);
    draw_reach(list, theme, plot, dashed, 0.01 * most);
    draw_names(ui, plot, overlay);
}

void draw_empty_overlay(const Ui& ui, const char* title, const std::string& reason) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect area =
        rect_at(corner, {ImGui::GetContentRegionAvail().x, kPreviewPx * ui.theme.scale});
    ImGui::Dummy(area.size());
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, title, reason);
}

}  // namespace tact
