#include "viz/charts/star_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tact {

namespace {

struct StarFrame {
    ImVec2 middle;
    float radius = 0.0F;  // of a 1
};

ImVec2 tip(const StarFrame& frame, std::size_t ray, std::size_t rays, double number) {
    const double turn = rays == 2 ? 0.25 : 1.0 / static_cast<double>(rays);
    const double angle = 2.0 * std::numbers::pi * turn * static_cast<double>(ray);
    const double length = std::clamp(number, 0.0, 1.0);
    return {frame.middle.x + frame.radius * static_cast<float>(length * std::sin(angle)),
            frame.middle.y - frame.radius * static_cast<float>(length * std::cos(angle))};
}

std::vector<ImVec2> star_outline(const StarFrame& frame, std::span<const double> numbers) {
    std::vector<ImVec2> points;
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        points.push_back(tip(frame, r, numbers.size(), numbers[r]));
    }
    if (numbers.size() < 3) points.push_back(frame.middle);
    return points;
}

// From the middle: a star with one short ray is not convex.
void fill_star(ImDrawList& canvas, const StarFrame& frame, const std::vector<ImVec2>& points,
               ImU32 colour) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        canvas.AddTriangleFilled(frame.middle, points[k], points[(k + 1) % points.size()], colour);
    }
}

}  // namespace

void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with) {
    const ImVec2 size{area.max.x - area.min.x, area.max.y - area.min.y};
    const StarFrame frame{{0.5F * (area.min.x + area.max.x), 0.5F * (area.min.y + area.max.y)},
                          0.5F * std::min(size.x, size.y)};
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        canvas.AddLine(frame.middle, tip(frame, r, numbers.size(), 1.0), theme.line);
    }
    const auto own = star_outline(frame, numbers);
    fill_star(canvas, frame, own, (theme.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90));
    canvas.AddPolyline(own.data(), static_cast<int>(own.size()), theme.accent, ImDrawFlags_Closed,
                       1.5F * theme.scale);
    const auto other = star_outline(frame, compared_with);
    canvas.AddPolyline(other.data(), static_cast<int>(other.size()), theme.dim_text,
                       ImDrawFlags_Closed, 1.0F * theme.scale);
}

}  // namespace tact
