#include "viz/space/space_framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tact {

namespace {

struct HalfPane {
    double width;
    double height;
};

HalfPane filled_half(const Rect& pane) {
    constexpr double kFilled = 0.92;  // the rest is for the sizes of points
    return {kFilled * std::max(1.0, static_cast<double>(pane.width()) / 2.0),
            kFilled * std::max(1.0, static_cast<double>(pane.height()) / 2.0)};
}

// Whatever the yaw.
Framing framed_for_all_yaws(const SpaceCamera& camera, const SpaceFit& fit, const HalfPane& half) {
    const double r = fit.cylinder_radius;
    const double h = std::max(std::abs(fit.cylinder_low), std::abs(fit.cylinder_high));
    constexpr double e = kEyeDistance;
    if (fit.flat) return {std::min(half.width, half.height) / r};
    const double ball = fit.farthest * e / std::sqrt(e * e - fit.farthest * fit.farthest);
    const double c = std::cos(camera.pitch_rad);
    const double s = std::sin(camera.pitch_rad);
    const double under_root = std::pow(e - h * std::abs(s), 2) - std::pow(r * c, 2);
    const double widest = std::min(ball, r * e / std::sqrt(under_root));
    double lowest = 0.0;
    double highest = 0.0;
    for (const double z : {fit.cylinder_low, fit.cylinder_high}) {
        for (const double away : {-r, r}) {
            const double y = (c * z + s * away) * e / (e - (s * z - c * away));
            lowest = std::max(-ball, std::min(lowest, y));
            highest = std::min(ball, std::max(highest, y));
        }
    }
    return {std::min(half.width / widest, 2.0 * half.height / (highest - lowest)), 0.0,
            (highest + lowest) / 2.0};
}

// The largest scale that keeps the extent in the pane, with this in the middle.
double largest_px(const SeenExtent& seen, const HalfPane& half, double across, double middle) {
    constexpr double kLeast = 0.05;  // one point needs no poster
    const double wide = std::max({seen.right - across, across - seen.left, kLeast});
    const double high = std::max({seen.high - middle, middle - seen.low, kLeast});
    return std::min(half.width / wide, half.height / high);
}

// 1: as at first, 0: turned well away from that.
double nearness_to_first(const SpaceCamera& camera, bool flat) {
    if (flat) return 1.0;
    constexpr double kAwayRad = 0.7;
    const SpaceCamera first;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    const double yaw = std::remainder(camera.yaw_rad - first.yaw_rad, kTurn);
    const double off = std::hypot(yaw, camera.pitch_rad - first.pitch_rad) / kAwayRad;
    const double near = std::clamp(1.0 - off, 0.0, 1.0);
    return near * near * (3.0 - 2.0 * near);
}

}  // namespace

SeenExtent seen_extent(const SpaceCamera& camera, const SpaceFit& fit) {
    const Eigen::Matrix3d turn = turn_of(camera, fit.flat);
    SeenExtent seen{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    for (const Eigen::Vector3d& outer : fit.outer) {
        const Eigen::Vector3d q = turn * outer;
        const double scale = fit.flat ? 1.0 : kEyeDistance / (kEyeDistance - q.z());
        seen.left = std::min(seen.left, q.x() * scale);
        seen.right = std::max(seen.right, q.x() * scale);
        seen.low = std::min(seen.low, q.y() * scale);
        seen.high = std::max(seen.high, q.y() * scale);
    }
    return seen;
}

Framing framed(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane) {
    const HalfPane half = filled_half(pane);
    const Framing all_yaws = framed_for_all_yaws(camera, fit, half);
    const double near = fit.outer.empty() ? 0.0 : nearness_to_first(camera, fit.flat);
    if (near <= 0.0) return all_yaws;
    const SeenExtent& at_first = fit.at_first;
    const double across = (at_first.left + at_first.right) / 2.0;
    const double middle = (at_first.low + at_first.high) / 2.0;
    const double px = largest_px(at_first, half, across, middle);
    Framing framing{all_yaws.radius_px + near * (px - all_yaws.radius_px), near * across,
                    all_yaws.middle + near * (middle - all_yaws.middle)};
    framing.radius_px = std::min(framing.radius_px, largest_px(seen_extent(camera, fit), half,
                                                               framing.across, framing.middle));
    return framing;
}

}  // namespace tact
