#include "viz/picture/shape_joining.h"

#include <doctest/doctest.h>

#include <cmath>

#include "viz/drawing/geometry.h"

namespace tact::mesh_outline_test {
namespace {

std::vector<ImDrawVert> vertices(const std::vector<ImVec2>& points) {
    std::vector<ImDrawVert> result;
    for (const ImVec2 p : points) result.push_back({p, {0, 0}, IM_COL32_WHITE});
    return result;
}

// Positive for an outline that runs clockwise on the screen.
double area_of(const Outline& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const ImVec2 a = outline[i];
        const ImVec2 b = outline[(i + 1) % outline.size()];
        twice += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    return twice / 2.0;
}

}  // namespace

TEST_CASE("outline: of a fan it is the rim, of a strip both its edges") {
    const auto square = vertices({{0, 0}, {8, 0}, {8, 4}, {8, 8}, {0, 8}});
    const auto rim = outlines_of({0, 1, 2, 0, 2, 3, 0, 3, 4}, square.data());
    REQUIRE(rim.size() == 1);
    CHECK(rim[0].size() == 5);
    CHECK(area_of(rim[0]) == 64.0);

    const auto strip = vertices({{0, 0}, {0, 2}, {3, 1}, {3, 5}, {6, 0}, {6, 2}});
    const auto edges = outlines_of({0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3}, strip.data());
    REQUIRE(edges.size() == 1);
    CHECK(edges[0].size() == 6);
    CHECK(area_of(edges[0]) == 18.0);
}

TEST_CASE("outline: a ring has a hole that runs the other way, two islands are two") {
    const auto ring = vertices({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {6, 3}, {6, 6}, {3, 6}});
    std::vector<ImDrawIdx> triangles;
    for (unsigned k = 0; k < 4; ++k) {
        const unsigned next = (k + 1) % 4;
        for (const unsigned i : {k, next, 4 + next, k, 4 + next, 4 + k}) {
            triangles.push_back(static_cast<ImDrawIdx>(i));
        }
    }
    const auto outlines = outlines_of(triangles, ring.data());
    REQUIRE(outlines.size() == 2);
    CHECK(area_of(outlines[0]) == 81.0);
    CHECK(area_of(outlines[1]) == -9.0);

    const auto apart = outlines_of({0, 1, 2, 4, 5, 6}, ring.data());
    CHECK(apart.size() == 2);
}

TEST_CASE("outline: made clockwise, it covers as much and stays so") {
    Outline left{{0, 0}, {0, 5}, {5, 5}, {5, 0}};
    REQUIRE(area_of(left) == -25.0);
    make_clockwise(left);
    CHECK(area_of(left) == 25.0);
    const Outline before = left;
    make_clockwise(left);
    for (std::size_t i = 0; i < before.size(); ++i) CHECK(same(left[i], before[i]));
}

}  // namespace tact::mesh_outline_test
