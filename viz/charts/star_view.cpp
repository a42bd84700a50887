#include "viz/charts/star_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tact {

namespace {

struct StarFrame {
    ImVec2 middle;
    float radius = 0.0F;  // length of a 1

    ImVec2 at(ImVec2 place) const { return middle + place * radius; }
};

std::vector<ImVec2> placed(const StarFrame& frame, std::span<const double> numbers) {
    std::vector<ImVec2> points = star_outline(numbers);
    for (ImVec2& point : points) point = frame.at(point);
    return points;
}

// Triangles from the centre: a star with one short ray is not convex.
void fill_star(ImDrawList& canvas, const StarFrame& frame, const std::vector<ImVec2>& points,
               ImU32 colour) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        canvas.AddTriangleFilled(frame.middle, points[k], points[(k + 1) % points.size()], colour);
    }
}

}  // namespace

ImVec2 star_ray(std::size_t ray, std::size_t rays) {
    const double turn = rays == 2 ? 0.25 : 1.0 / static_cast<double>(rays);
    const double angle = 2.0 * std::numbers::pi * turn * static_cast<double>(ray);
    return {static_cast<float>(std::sin(angle)), static_cast<float>(-std::cos(angle))};
}

std::vector<ImVec2> star_outline(std::span<const double> numbers) {
    std::vector<ImVec2> points;
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        const auto length = static_cast<float>(std::clamp(numbers[r], 0.0, 1.0));
        points.push_back(star_ray(r, numbers.size()) * length);
    }
    if (numbers.size() < 3) points.push_back({0.0F, 0.0F});
    return points;
}

void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with) {
    const StarFrame frame{area.centre(), 0.5F * std::min(area.width(), area.height())};
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        canvas.AddLine(frame.middle, frame.at(star_ray(r, numbers.size())), theme.line,
                       theme.hairline_px);
    }
    const auto own = placed(frame, numbers);
    fill_star(canvas, frame, own, (theme.series & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90));
    canvas.AddPolyline(own.data(), static_cast<int>(own.size()), theme.series, ImDrawFlags_Closed,
                       1.5F * theme.scale);
    const auto other = placed(frame, compared_with);
    canvas.AddPolyline(other.data(), static_cast<int>(other.size()), theme.dim_text,
                       ImDrawFlags_Closed, 1.0F * theme.scale);
}

}  // namespace tact
