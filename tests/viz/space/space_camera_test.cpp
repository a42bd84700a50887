#include "viz/space/space_camera.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace tact::space_camera_test {
namespace {

Eigen::MatrixXd random_points(int n, int dimensions, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> value(3.0, 20.0);
    Eigen::MatrixXd points(n, dimensions);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < dimensions; ++k) points(i, k) = value(random) / (k + 1);
    }
    return points;
}

const Rect kPane{{100, 50}, {740, 450}};

}  // namespace

TEST_CASE("space: at zoom 1 no point nor its foot leaves the pane, however it is turned") {
    for (const int dimensions : {2, 3}) {
        for (unsigned seed = 0; seed < 10; ++seed) {
            const auto points = random_points(20, dimensions, seed);
            const SpaceFit f = fit(points);
            for (double yaw = 0.0; yaw < 6.3; yaw += 0.4) {
                for (double pitch = -0.2; pitch < 1.58; pitch += 0.3) {
                    const SpaceCamera camera{.yaw_rad = yaw, .pitch_rad = pitch};
                    for (int i = 0; i < 20; ++i) {
                        Eigen::Vector3d p = point_of(points, i);
                        CHECK(kPane.contains(project(camera, f, kPane, p).at));
                        p.z() = f.floor - kFloorBelow * f.radius;
                        if (dimensions == 3) CHECK(kPane.contains(project(camera, f, kPane, p).at));
                    }
                }
            }
        }
    }
}

TEST_CASE("space: as it is first seen, points and their feet fill the pane") {
    for (const int dimensions : {2, 3}) {
        for (const int n : {3, 12, 300}) {
            for (unsigned seed = 0; seed < 6; ++seed) {
                const auto points = random_points(n, dimensions, seed);
                const SpaceFit f = fit(points);
                ImVec2 low{1e6F, 1e6F};
                ImVec2 high{-1e6F, -1e6F};
                const auto see = [&](const Eigen::Vector3d& p) {
                    const ImVec2 at = project({}, f, kPane, p).at;
                    CHECK(kPane.contains(at));
                    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
                    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
                };
                for (int i = 0; i < n; ++i) {
                    const Eigen::Vector3d p = point_of(points, i);
                    see(p);
                    const double foot = f.floor - kFloorBelow * f.radius;
                    if (dimensions == 3) see({p.x(), p.y(), foot});
                }
                const float wide = (high.x - low.x) / kPane.width();
                const float tall = (high.y - low.y) / kPane.height();
                CHECK(std::max(wide, tall) > 0.85F);
            }
        }
    }
}

TEST_CASE("space: tilting by a little moves every point by a little") {
    const auto points = random_points(20, 3, 8);
    const SpaceFit f = fit(points);
    for (double pitch = -0.2; pitch < 1.57; pitch += 0.001) {
        const ImVec2 a = project({.pitch_rad = pitch}, f, kPane, point_of(points, 3)).at;
        const ImVec2 b = project({.pitch_rad = pitch + 0.001}, f, kPane, point_of(points, 3)).at;
        // 1 mrad of 200 px is 0.2 px; the framing may add as much again, and corners of it.
        CHECK(std::hypot(a.x - b.x, a.y - b.y) <= 1.0F);
    }
}

TEST_CASE("space: a point picked where it is drawn is that point, or one in front of it") {
    const auto points = random_points(50, 3, 3);
    const SpaceFit f = fit(points);
    const SpaceCamera camera;
    std::vector<Disc> discs;
    std::vector<double> depth;
    for (int i = 0; i < 50; ++i) {
        const Projected p = project(camera, f, kPane, point_of(points, i));
        discs.push_back({p.at, 6.0F});
        depth.push_back(p.depth);
    }
    std::vector<std::size_t> order(50);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return depth[a] > depth[b]; });
    for (std::size_t i = 0; i < 50; ++i) {
        const auto found = pick(discs, order, discs[i].centre, 4.0F);
        REQUIRE(found.has_value());
        CHECK(depth[*found] >= depth[i]);
    }
    CHECK_FALSE(pick(discs, order, {0, 0}, 4.0F).has_value());
}

TEST_CASE("space: the nearer of two points in line with the eye is picked") {
    const std::vector<Disc> discs{{{10, 10}, 5}, {{11, 10}, 5}};
    CHECK(pick(discs, std::vector<std::size_t>{1, 0}, {10, 10}, 4.0F) == 1U);
    CHECK(pick(discs, std::vector<std::size_t>{0, 1}, {10, 10}, 4.0F) == 0U);
}

TEST_CASE("space: zooming leaves what is under the mouse where it is") {
    const auto points = random_points(12, 3, 4);
    const SpaceFit f = fit(points);
    SpaceCamera camera;
    const ImVec2 before = project(camera, f, kPane, point_of(points, 5)).at;
    zoom_at(camera, kPane, before, 2.5);
    const ImVec2 after = project(camera, f, kPane, point_of(points, 5)).at;
    CHECK(camera.zoom == 2.5);
    // Float pixels of magnitude 500.
    CHECK(std::abs(after.x - before.x) <= 1e-3F);
    CHECK(std::abs(after.y - before.y) <= 1e-3F);
    zoom_at(camera, kPane, before, 1e9);
    CHECK(camera.zoom == kMostZoom);
}

TEST_CASE("space: nearer points are larger, and dimensions point right, away and up") {
    Eigen::MatrixXd points(3, 3);
    points << -1, 0, 0, 1, 0, 0, 0, -1, 0;
    const SpaceFit f = fit(points);
    const SpaceCamera level{.yaw_rad = 0.0, .pitch_rad = 0.0};
    const Projected left = project(level, f, kPane, point_of(points, 0));
    const Projected right = project(level, f, kPane, point_of(points, 1));
    const Projected front = project(level, f, kPane, point_of(points, 2));
    CHECK(left.at.x < right.at.x);
    CHECK(front.depth > right.depth);
    CHECK(front.scale > right.scale);
    CHECK(turned(level, false, Eigen::Vector3d::UnitZ()).y() == 1.0);
}

TEST_CASE("space: a flat map is seen from above, whatever the camera's turn") {
    const auto points = random_points(5, 2, 6);
    const SpaceFit f = fit(points);
    const SpaceCamera turned_away{.yaw_rad = 2.0, .pitch_rad = 0.1};
    for (int i = 0; i < 5; ++i) {
        CHECK(same(project(SpaceCamera{}, f, kPane, point_of(points, i)).at,
                   project(turned_away, f, kPane, point_of(points, i)).at));
    }
}

TEST_CASE("space: one point, equal points, missing points and none still have a place") {
    Eigen::MatrixXd equal = Eigen::MatrixXd::Constant(3, 3, 7.0);
    const ImVec2 at = project({}, fit(equal), kPane, point_of(equal, 0)).at;
    CHECK(std::abs(at.x - kPane.centre().x) <= 1e-3F);
    CHECK(std::abs(at.y - kPane.centre().y) <= 0.2F * kPane.height());
    equal(1, 1) = NAN;
    CHECK(fit(equal).radius == 1.0);
    CHECK(fit(Eigen::MatrixXd(0, 3)).radius == 1.0);
}

}  // namespace tact::space_camera_test
