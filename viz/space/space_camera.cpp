#include "viz/space/space_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tact {

namespace {

double half_side_px(const Rect& pane) {
    return std::max(1.0, static_cast<double>(std::min(pane.width(), pane.height())) / 2.0);
}

bool finite(const Eigen::Vector3d& p) { return p.allFinite(); }

// Shrinks the ball around the bounding box's centre toward the smallest one (Ritter 1990: move the
// centre a little toward the farthest point, again and again; Badoiu & Clarkson 2003 for the
// steps).
void enclose(const Eigen::MatrixXd& points, SpaceFit& result) {
    for (int step = 0; step <= 60; ++step) {
        Eigen::Vector3d farthest = result.centre;
        double distance = 0.0;
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const Eigen::Vector3d p = point_of(points, i);
            if (!finite(p) || (p - result.centre).norm() <= distance) continue;
            distance = (p - result.centre).norm();
            farthest = p;
        }
        result.radius = distance;
        if (step < 60) result.centre += (farthest - result.centre) / (step + 2.0);
    }
}

// The cylinder around the points and their feet on the floor.
void enclose_upright(const Eigen::MatrixXd& points, SpaceFit& result) {
    result.cylinder_radius = 0.0;
    result.cylinder_high = 0.0;
    result.farthest = 0.0;
    result.cylinder_low = (result.floor - result.centre.z()) / result.radius - kFloorBelow;
    if (result.flat) result.cylinder_low = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Vector3d q = (point_of(points, i) - result.centre) / result.radius;
        if (!finite(q)) continue;
        const double aside = q.head<2>().norm();
        result.cylinder_radius = std::max(result.cylinder_radius, aside);
        result.cylinder_high = std::max(result.cylinder_high, q.z());
        result.farthest =
            std::max({result.farthest, q.norm(), std::hypot(aside, result.cylinder_low)});
    }
}

// Directions all around, evenly spread: a spiral of golden angles.
Eigen::Vector3d direction(int k, int count) {
    const double up = 1.0 - (2.0 * k + 1.0) / count;
    const double angle = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double wide = std::sqrt(1.0 - up * up);
    return {wide * std::cos(angle), wide * std::sin(angle), up};
}

void keep_outer(const Eigen::MatrixXd& points, SpaceFit& result) {
    constexpr int kDirections = 60;
    const double foot = (result.floor - result.centre.z()) / result.radius - kFloorBelow;
    for (int k = 0; k < kDirections; ++k) {
        const Eigen::Vector3d toward = direction(k, kDirections);
        double farthest = -HUGE_VAL;
        Eigen::Vector3d outer = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            Eigen::Vector3d q = (point_of(points, i) - result.centre) / result.radius;
            if (!finite(q)) continue;
            if (!result.flat && toward.z() < 0.0) q.z() = foot;
            if (q.dot(toward) <= farthest) continue;
            farthest = q.dot(toward);
            outer = q;
        }
        result.outer.push_back(outer);
    }
    result.at_first = seen_extent({}, result);
}

}  // namespace

Eigen::Vector3d point_of(const Eigen::MatrixXd& points, Eigen::Index i) {
    return {points.cols() > 0 ? points(i, 0) : 0.0, points.cols() > 1 ? points(i, 1) : 0.0,
            points.cols() > 2 ? points(i, 2) : 0.0};
}

SpaceFit fit(const Eigen::MatrixXd& points) {
    SpaceFit result;
    result.flat = points.cols() < 3;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL);
    Eigen::Vector3d high = -low;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Vector3d p = point_of(points, i);
        if (!finite(p)) continue;
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    if (!(low.x() <= high.x())) return result;
    result.centre = (low + high) / 2.0;
    result.floor = low.z();
    enclose(points, result);
    if (result.radius <= 1e-12) {
        result.radius = 1.0;
        return result;
    }
    enclose_upright(points, result);
    keep_outer(points, result);
    // A map that is one upright line would otherwise fill the pane's height and more.
    result.cylinder_radius = std::max(result.cylinder_radius, 0.1);
    return result;
}

Eigen::Matrix3d turn_of(const SpaceCamera& camera, bool flat) {
    const double yaw = flat ? 0.0 : camera.yaw_rad;
    const double pitch = flat ? std::numbers::pi / 2.0 : camera.pitch_rad;
    const Eigen::RowVector3d away{std::sin(yaw), std::cos(yaw), 0.0};
    const Eigen::RowVector3d upright = Eigen::RowVector3d::Unit(2);
    Eigen::Matrix3d turn;
    turn.row(0) << std::cos(yaw), -std::sin(yaw), 0.0;
    turn.row(1) = std::cos(pitch) * upright + std::sin(pitch) * away;
    turn.row(2) = std::sin(pitch) * upright - std::cos(pitch) * away;
    return turn;
}

Eigen::Vector3d turned(const SpaceCamera& camera, bool flat, const Eigen::Vector3d& direction) {
    return turn_of(camera, flat) * direction;
}

SpaceProjection projection(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane) {
    const Framing framing = framed(camera, fit, pane);
    const double half = half_side_px(pane);
    return {.turn = turn_of(camera, fit.flat) / fit.radius,
            .centre = fit.centre,
            .flat = fit.flat,
            .middle = pane.centre() + ImVec2{static_cast<float>(camera.pan_x * half),
                                             static_cast<float>(camera.pan_y * half)},
            .px = camera.zoom * framing.radius_px,
            .across = framing.across,
            .up = framing.middle};
}

Projected SpaceProjection::operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d q = turn * (point - centre);
    // Far outside the ball (a ghost of another map) nothing may come behind the eye.
    const double near = std::min(q.z(), 0.75 * kEyeDistance);
    const double scale = flat ? 1.0 : kEyeDistance / (kEyeDistance - near);
    return {middle + ImVec2{static_cast<float>(px * (q.x() * scale - across)),
                            -static_cast<float>(px * (q.y() * scale - up))},
            q.z(), scale};
}

Projected project(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                  const Eigen::Vector3d& point) {
    return projection(camera, fit, pane)(point);
}

Eigen::Vector3d unprojected(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                            const Eigen::Vector3d& through, ImVec2 at) {
    const SpaceProjection seen = projection(camera, fit, pane);
    const Projected before = seen(through);
    const double px = seen.px * before.scale;
    const double right = static_cast<double>(at.x - before.at.x) / px;
    const double up = -static_cast<double>(at.y - before.at.y) / px;
    // The screen's right and up in the map.
    return through +
           fit.radius * (turn_of(camera, fit.flat).transpose() * Eigen::Vector3d(right, up, 0.0));
}

std::optional<std::size_t> pick(std::span<const Disc> discs,
                                std::span<const std::size_t> front_to_back, ImVec2 at,
                                float reach_px) {
    std::optional<std::size_t> nearest;
    float best = reach_px;
    for (const std::size_t i : front_to_back) {
        const ImVec2 away = discs[i].centre - at;
        const float gap = std::hypot(away.x, away.y) - discs[i].radius;
        if (gap <= 0.0F) return i;
        if (gap < best) {
            best = gap;
            nearest = i;
        }
    }
    return nearest;
}

void zoom_at(SpaceCamera& camera, const Rect& pane, ImVec2 mouse, double factor) {
    const double zoom = std::clamp(camera.zoom * factor, kLeastZoom, kMostZoom);
    const double ratio = zoom / camera.zoom;
    const double half = half_side_px(pane);
    const double x = static_cast<double>(mouse.x - pane.centre().x) / half;
    const double y = static_cast<double>(mouse.y - pane.centre().y) / half;
    camera.pan_x = x - (x - camera.pan_x) * ratio;
    camera.pan_y = y - (y - camera.pan_y) * ratio;
    camera.zoom = zoom;
}

void look_along(SpaceCamera& camera, int axis) {
    SpaceCamera straight;
    straight.locked = camera.locked;
    straight.drag = camera.drag;
    constexpr double kQuarter = std::numbers::pi / 2.0;
    if (axis < 3) {
        straight.yaw_rad = axis == 0 ? -kQuarter : 0.0;
        straight.pitch_rad = axis == 2 ? kQuarter : 0.0;
    }
    camera = straight;
}

void frame_points(SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                  const std::vector<Eigen::Vector3d>& points) {
    constexpr double kFills = 0.6;  // names want room
    constexpr double kMostFramedZoom = 8.0;
    if (points.empty()) return;
    camera.pan_x = 0.0;
    camera.pan_y = 0.0;
    camera.zoom = 1.0;
    const SpaceProjection projected = projection(camera, fit, pane);
    Rect seen{projected(points.front()).at, {}};
    seen.max = seen.min;
    for (const Eigen::Vector3d& point : points) {
        const ImVec2 at = projected(point).at;
        seen = around(seen, {at, at});
    }
    const auto times = [](float room, float extent) {
        return extent > 0.0F ? kFills * static_cast<double>(room / extent) : kMostFramedZoom;
    };
    camera.zoom =
        std::clamp(std::min(times(pane.width(), seen.width()), times(pane.height(), seen.height())),
                   0.5, kMostFramedZoom);
    const ImVec2 off = seen.centre() - pane.centre();
    const double half = half_side_px(pane);
    camera.pan_x = -camera.zoom * static_cast<double>(off.x) / half;
    camera.pan_y = -camera.zoom * static_cast<double>(off.y) / half;
}

void orbit(SpaceCamera& camera, ImVec2 drag_px, float scale) {
    constexpr double kRadPerPx = 0.008;
    constexpr double kMostPitch = std::numbers::pi / 2.0;
    camera.yaw_rad += static_cast<double>(drag_px.x / scale) * kRadPerPx;
    camera.pitch_rad = std::clamp(
        camera.pitch_rad + static_cast<double>(drag_px.y / scale) * kRadPerPx, -0.2, kMostPitch);
}

void pan(SpaceCamera& camera, const Rect& pane, ImVec2 drag_px) {
    camera.pan_x += static_cast<double>(drag_px.x) / half_side_px(pane);
    camera.pan_y += static_cast<double>(drag_px.y) / half_side_px(pane);
}

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
