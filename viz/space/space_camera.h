// Looking at a map of points: where each appears on the screen, and which one is under the mouse.
//
//     q = (p - centre) / radius                  all points within the unit ball
//     (x, y, depth) = q turned by yaw about D3, then tilted by pitch
//     (X, Y) = (x, y) E / (E - depth)            E = distance of the eye
//     screen = middle + pan + zoom fit (X, -(Y - mid))
//
// fit and mid are a scale and a shift at which no point leaves the pane at zoom 1. As the camera
// stands at first, and in a flat map, points and the feet of their drop lines fill the pane: the
// largest there is. Turned away from that it shrinks to what holds whatever the yaw, so that the
// map does not breathe while it is turned. Two bounds hold at once there, both found by maximising
// over the yaw:
//     ball       of radius R: |X|, |Y| <= R E / sqrt(E^2 - R^2)
//     cylinder   of radius r and a height h at most on either side of the centre:
//                |X| <= r E / sqrt((E - h sin p)^2 - (r cos p)^2),
//                Y between its values at the front's lower and the back's upper edge
//
// Left out  roll, a moving centre of rotation.
#pragma once

#include <imgui.h>
#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "viz/drawing/geometry.h"

namespace tact {

inline constexpr double kEyeDistance = 4.0;  // in radii of the map
inline constexpr double kLeastZoom = 0.2;
inline constexpr double kMostZoom = 40.0;

// What a drag with the left button does: by where it began, and the keys that were held.
enum class SpaceGesture { none, orbit, between, box, lasso, move };

struct SpaceDrag {
    SpaceGesture gesture = SpaceGesture::none;
    std::optional<std::size_t> from{};  // the point that it began on
    std::vector<ImVec2> line{};         // the mouse's way

    bool operator==(const SpaceDrag& other) const {
        return gesture == other.gesture && from == other.from &&
               std::ranges::equal(line, other.line, same);
    }
};

struct SpaceCamera {
    double yaw_rad = -0.45;
    double pitch_rad = 0.55;  // 0: from the side; pi/2: from above
    double zoom = 1.0;
    double pan_x = 0.0;  // in half sides of the pane's smaller extent
    double pan_y = 0.0;
    bool locked = false;  // the mouse turns, moves and zooms nothing
    SpaceDrag drag{};     // under way

    bool operator==(const SpaceCamera&) const = default;
};

// What is seen of a map, in ball radii from its centre.
struct SeenExtent {
    double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
};

// Where a map lies: maps of 2 and of 3 dimensions alike, points that are not finite left out.
struct SpaceFit {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 1.0;  // of the ball around all points; 1 for fewer than two different ones
    // The upright cylinder around the points and their feet on the floor, from the centre, in ball
    // radii; and the farthest of all that.
    double cylinder_radius = 1.0;
    double cylinder_low = -1.0;
    double cylinder_high = 1.0;
    double farthest = 1.0;
    double floor = 0.0;  // lowest D3
    bool flat = false;   // 2-D: seen from above, without perspective; the camera's turn is ignored
    // Those farthest out in directions all around, and feet on the floor, in ball radii from the
    // centre; and what is seen of them by the camera as it is at first.
    std::vector<Eigen::Vector3d> outer{};
    SeenExtent at_first{};
};

inline constexpr double kFloorBelow = 0.12;  // the lowest point, in ball radii

SpaceFit fit(const Eigen::MatrixXd& points);

// Row i as a point in space; D3 = 0 in 2-D.
Eigen::Vector3d point_of(const Eigen::MatrixXd& points, Eigen::Index i);

// Turns a direction to what the eye sees: (right, up, toward the eye). `flat`: from straight above.
Eigen::Matrix3d turn_of(const SpaceCamera& camera, bool flat);
Eigen::Vector3d turned(const SpaceCamera& camera, bool flat, const Eigen::Vector3d& direction);

struct Projected {
    ImVec2 at{0, 0};
    double depth = 0.0;  // -1 (far) to 1 (near)
    double scale = 1.0;  // of sizes there, 1 in the middle
};

// Where points appear to a camera that stands still, its angles and its framing taken once: a frame
// asks this a thousand times.
struct SpaceProjection {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // to (right, up, toward the eye), in radii
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    bool flat = false;
    ImVec2 middle{0, 0};            // of the pane, moved by the pan
    double px = 1.0;                // of one radius in the middle
    double across = 0.0, up = 0.0;  // what of X and Y is there

    Projected operator()(const Eigen::Vector3d& point) const;
};

SpaceProjection projection(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane);

// Projects a single point.
Projected project(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                  const Eigen::Vector3d& point);

struct Disc {
    ImVec2 centre{0, 0};
    float radius = 0.0F;
};

// The point of the plane through `through`, parallel to the screen, that is seen there.
Eigen::Vector3d unprojected(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                            const Eigen::Vector3d& through, ImVec2 at);

// The disc under a point: the first in `front_to_back` that contains it, or the nearest within
// `reach_px` of an edge.
std::optional<std::size_t> pick(std::span<const Disc> discs,
                                std::span<const std::size_t> front_to_back, ImVec2 at,
                                float reach_px);

// Zooms by a factor so that what is under the mouse stays there.
void zoom_at(SpaceCamera& camera, const Rect& pane, ImVec2 mouse, double factor);

// Straight along an axis of the map: D1 from the side, D2 from the front, D3 from above; of 3: as
// it is at first. The map is unmoved and unzoomed then.
void look_along(SpaceCamera& camera, int axis);

// Moves and zooms so that these points of a map fill most of the pane.
void frame_points(SpaceCamera& camera, const SpaceFit& fit, const Rect& pane,
                  const std::vector<Eigen::Vector3d>& points);

void orbit(SpaceCamera& camera, ImVec2 drag_px, float scale);
void pan(SpaceCamera& camera, const Rect& pane, ImVec2 drag_px);

// How large a map is in its pane, and what is in the middle of that. Private to the
// camera.

// Pixels of one radius at zoom 1, and what of X and Y is in the middle of the pane.
struct Framing {
    double radius_px;
    double across = 0.0;
    double middle = 0.0;
};

Framing framed(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane);

// What the camera sees of the outer points.
SeenExtent seen_extent(const SpaceCamera& camera, const SpaceFit& fit);

}  // namespace tact
