// The work of a frame is bounded: the pairs of large sets are sorted in the background, once.

#include <doctest/doctest.h>

#include "app/compare/compare.h"
#include "tests/support/compare_bench.h"

namespace bounded_frames_test {

using namespace tact;

TEST_CASE(
    "shepard tab: the pairs of a large set are sorted beside the window, and come out alike") {
    constexpr std::size_t kMany = 210;  // 21,945 pairs
    Dissimilarity matrix{kMany, {}};
    PerceptualSpace space;
    space.points = Eigen::MatrixXd(static_cast<Eigen::Index>(kMany), 3);
    for (Eigen::Index k = 0; k < space.points.size(); ++k) {
        space.points.data()[k] = static_cast<double>((k * 7919) % 1009) / 1009.0;
    }
    for (std::size_t k = 0; k < pair_count(kMany); ++k) {
        matrix.condensed.push_back(static_cast<double>((k * 104729) % 9973));
    }
    CompareBench bench;
    App& app = bench.program.app;
    // Makes the map on screen one of this many patterns.
    auto map = std::make_shared<LiveMap>(*app.shown_map.transition.shown);
    map->prediction.pm = matrix;
    map->space = space;
    auto set = std::make_shared<PatternSet>(short_patterns(kMany));
    map->request.set = set;
    MapTransition& shown = app.shown_map.transition;
    shown.shown = map;
    shown.from = shown.to = shown.ghost = space.points;
    app.layout.bench = BenchTab::shepard;
    bench.program.frame();
    // A slow machine may have sorted them before the frame ends.
    CHECK(bench.program.shows("shepard:waits") == (app.comparing.panel.fit == nullptr));
    bench.wait_until([&] { return app.comparing.panel.fit != nullptr; });
    const ShepardFit expected = shepard_fit({map, &map->prediction.pm, &map->space});
    CHECK(app.comparing.panel.fit->disparities == expected.disparities);
    CHECK_FALSE(bench.program.shows("shepard:waits"));
}

TEST_CASE("matrix tab: the largest value is looked for once a map and quantity") {
    CompareBench bench;
    App& app = bench.program.app;
    app.layout.bench = BenchTab::matrix;
    bench.program.settle();
    const Dissimilarity& pm = app.shown_map.transition.shown->prediction.pm;
    CHECK(app.shown_map.largest.value == std::ranges::max(pm.condensed));
    app.shown_map.largest.value = 1e6;  // every later look finds less left
    bench.program.settle();
    CHECK(app.shown_map.largest.value == 1e6);
    app.shown_map.quantity = MatrixQuantity::nc;
    bench.program.settle();
    const Dissimilarity& nc = app.shown_map.transition.shown->prediction.nc;
    CHECK(app.shown_map.largest.value == std::ranges::max(nc.condensed));
}

}  // namespace bounded_frames_test
