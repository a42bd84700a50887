// How the weakest pair fares with other counts.

#include <algorithm>
#include <cmath>

#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr const char* kCounted = "picked";  // on a line of its own: the last count keeps its place

// Whole numbers below the curve, as many as have room, and what they count. The chosen one stands
// in any case.
void draw_counts(const Ui& ui, const Plot& plot, const PickCurve& curve, std::size_t chosen) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = plot.area.max.y + 3.0F * theme.scale;
    const auto place = [&plot](const ImFont* font, std::size_t count) {
        const float width = text_size(font, std::to_string(count)).x;
        const float left = to_pixel(plot.x, static_cast<double>(count)) - 0.5F * width;
        return Range{double{left}, double{left + width}};
    };
    const double gap = double{theme.gap_px};
    const Range own = place(theme.fonts.semibold, chosen);
    double free = double{plot.area.min.x} - gap;
    for (const CurvePoint& point : curve.points) {
        const bool is_chosen = point.count == chosen;
        const ImFont* font = is_chosen ? theme.fonts.semibold : theme.fonts.small;
        const Range at = place(font, point.count);
        const bool meets_chosen = at.high + 0.5 * gap > own.low && at.low - 0.5 * gap < own.high;
        const bool has_room = at.low >= free && !meets_chosen;
        if (!is_chosen && !has_room) continue;
        draw_text(list, font, {static_cast<float>(at.low), y},
                  is_chosen ? theme.text : theme.dim_text, std::to_string(point.count));
        free = at.high + gap;
    }
    const float below = y + text_size(theme.fonts.semibold, "0").y;
    const float left = plot.area.max.x - text_size(theme.fonts.small, kCounted).x;
    draw_text(list, theme.fonts.small, {left, below}, theme.dim_text, kCounted);
}

// A line down to its count, and how far apart its weakest pair is: above it, on the side where the
// curve, which falls, is not.
void draw_chosen(Ui& ui, const Plot& plot, const CurvePoint& point, ImVec2 at) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_upright_line(list, at.x, at.y, plot.area.max.y, theme.hairline_px, theme.dim_text);
    const std::string text = worth_text(point.weakest);
    const ImVec2 size = text_size(theme.fonts.semibold, text);
    const float away = 0.75F * theme.gap_px;
    const ImVec2 corner{std::min(at.x + 0.5F * away, plot.area.max.x - size.x),
                        std::max(plot.area.min.y, at.y - size.y - away)};
    draw_text_halo(list, theme.fonts.semibold, corner, theme.text, theme.pane, 2.0F * theme.scale,
                   text);
    note_rect(ui.rects, "curve chosen", corner, corner + size, text);
}

// How far apart the weakest pair is for each k; a click chooses k.
// The axes, with the counts below them.
Plot draw_frame(const Ui& ui, const SubsetState& picking, const Rect& area) {
    const PickCurve& curve = *picking.curve;
    const Theme& theme = ui.theme;
    double most = 0.0;
    for (const CurvePoint& point : curve.points) most = std::max(most, point.bound);
    const auto first = static_cast<double>(curve.points.front().count);
    const auto last = static_cast<double>(curve.points.back().count);
    const std::string title = shortened(
        theme.fonts.small,
        (picking.objective == SubsetObjective::max_sum ? "weakest pair, were it picked by that, "
                                                       : "weakest pair, ") +
            quantity_of(curve.request, curve.mark),
        area.width());
    const PlotLabels labels{"", title, true};
    const float half_px =
        0.5F * text_size(theme.fonts.semibold, std::to_string(curve.points.back().count)).x;
    const float foot = text_size(theme.fonts.semibold, "0").y +
                       text_size(theme.fonts.small, kCounted).y + 3.0F * theme.scale;
    const Rect above{area.min, {area.max.x - half_px, area.max.y - foot}};
    const Plot plot =
        plot_within(above, theme, {first - 0.5, last + 0.5}, {0.0, 1.05 * most}, labels);
    draw_axes(*ImGui::GetWindowDrawList(), theme, plot, labels);
    draw_counts(ui, plot, curve, static_cast<std::size_t>(picking.count));
    return plot;
}

// The points with a line through them, and what is not proven above them; returns their places.
std::vector<ImVec2> draw_line(Ui& ui, const SubsetState& picking, const Plot& plot,
                              std::optional<std::size_t> hovered) {
    const PickCurve& curve = *picking.curve;
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::vector<ImVec2> line;
    for (const CurvePoint& point : curve.points) {
        const float x = to_pixel(plot.x, static_cast<double>(point.count));
        line.push_back({x, to_pixel(plot.y, point.weakest)});
        if (point.bound > point.weakest) {
            draw_upright_line(list, x, to_pixel(plot.y, point.bound), line.back().y,
                              theme.hairline_px, theme.warning);
        }
    }
    draw_path(list, line, theme.dim_text, theme.trace_px);
    for (std::size_t k = 0; k < line.size(); ++k) {
        const std::size_t count = curve.points[k].count;
        const bool lit = count == static_cast<std::size_t>(picking.count) || hovered == k;
        draw_disc(list, theme, line[k], (lit ? 5.0F : 3.0F) * theme.scale,
                  lit ? theme.accent : theme.dim_text);
        note_rect(ui.rects, "curve point:" + std::to_string(count), line[k], line[k]);
    }
    return line;
}

void draw_points(Ui& ui, SubsetState& picking, const Rect& area) {
    const std::vector<CurvePoint>& points = picking.curve->points;
    const Plot plot = draw_frame(ui, picking, area);
    ImGui::SetCursorScreenPos(area.min);
    const bool pressed = ImGui::InvisibleButton("curve", area.size());
    std::optional<std::size_t> hovered;
    if (ImGui::IsItemHovered()) {
        const auto first = static_cast<double>(points.front().count);
        const double k = std::round(to_value(plot.x, ImGui::GetIO().MousePos.x));
        if (k >= first && k <= static_cast<double>(points.back().count))
            hovered = static_cast<std::size_t>(k - first);
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    note_rect(ui.rects, "subset:curve", plot.area.min, plot.area.max,
              std::to_string(points.size()));
    const std::vector<ImVec2> line = draw_line(ui, picking, plot, hovered);
    if (!hovered) {
        const auto chosen =
            std::ranges::find(points, static_cast<std::size_t>(picking.count), &CurvePoint::count);
        if (chosen == points.end()) return;
        return draw_chosen(ui, plot, *chosen,
                           line[static_cast<std::size_t>(chosen - points.begin())]);
    }
    const CurvePoint& point = points[*hovered];
    const std::vector<std::string> lines{std::to_string(point.count) + " picked",
                                         "weakest pair " + worth_text(point.weakest),
                                         point.bound > point.weakest ? "not proven" : "proven"};
    draw_readout(*ImGui::GetWindowDrawList(), ui.theme, area, line[*hovered], lines);
    if (pressed) picking.count = static_cast<int>(point.count);
}

bool is_busy(const SubsetState& picking) { return picking.curve_job.busy(); }

}  // namespace

std::string worth_text(double worth) {
    std::string text = grouped(worth, 4);
    if (text.find('.') == text.npos) return text;
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
}

bool has_curve(const SubsetState& picking) { return picking.curve || is_busy(picking); }

void draw_curve(Ui& ui, const ShownMap& shown_map, SubsetState& picking, const Rect& area) {
    if (area.width() < 90.0F || area.height() < 70.0F) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (picking.curve && picking.curve->points.size() > 1) {
        draw_points(ui, picking, area);
        const bool behind = picking.curve->request != picking.curve_asked ||
                            picking.curve->request.map != shown_map.transition.shown;
        if (looks_stale(ui, "curve", picking.curve, behind))
            draw_stale(list, ui.theme, area, ImGui::GetTime());
        return;
    }
    if (!is_busy(picking)) return;
    const std::string text = percent_done(picking.curve_job.progress()) + " done";
    draw_empty(list, ui.theme, area, "Trying other counts", text);
}

}  // namespace tact
