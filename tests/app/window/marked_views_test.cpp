// Marks on a set's model and on its raters appear in every picture of the window and its panes, and
// in every copied table.
#include <doctest/doctest.h>

#include "app/candidates/candidates.h"
#include "app/compare/compare.h"
#include "app/window/window.h"
#include "tests/support/compare_bench.h"
#include "tests/support/run_program.h"

namespace marked_views_test {

using namespace tact;

namespace {

PatternSet set_of_nobody() {
    PatternSet set = short_patterns(kRatedPatterns);
    set.model.nc_weight = 0.6;
    set.model_origin = {"Trained on r.csv.", true, false};
    return set;
}

// Two simulated participants who count, one who is left out, and a rehearsal.
std::string lines_of_nobody() {
    std::string lines = "participant,a,b,rating,synthetic,excluded,rehearsal\n";
    for (const char* who : {"S1,1,0,0", "S2,1,0,0", "S3,1,1,0", "S4,1,0,1"}) {
        for (std::size_t i = 1; i <= kRatedPatterns; ++i) {
            for (std::size_t j = i + 1; j <= kRatedPatterns; ++j) {
                lines += std::string(who, 2) + ",p" + std::to_string(i) + ",p" + std::to_string(j) +
                         "," + std::to_string((7 * i + 5 * j * j) % 23 + 1) + (who + 2) + "\n";
            }
        }
    }
    return lines;
}

std::string svg_of(const App& app, PictureView view) {
    const auto still = snapshot_of(app);
    PictureSize size;
    size.format = PictureFormat::svg;
    return std::get<Svg>(view_picture(*still, view, 0.02, size)).text;
}

constexpr const char* kLeftOut = "2 participants left out, 1 rehearsal among them";

}  // namespace

TEST_CASE("marked views: every picture says that the model was trained on what nobody said" *
          doctest::test_suite("long")) {
    CompareBench bench(set_of_nobody());
    for (const Arrangement arrangement : {Arrangement::design, Arrangement::select}) {
        bench.program.app.layout.arrangement = arrangement;
        bench.program.settle();
        for (const PictureView view : kPictureViews) {
            CHECK_MESSAGE(contains(svg_of(bench.program.app, view), "trained on synthetic"),
                          name_of(view));
        }
    }
}

TEST_CASE("marked views: what is compared with ratings says whose they are, and who is left out" *
          doctest::test_suite("long")) {
    CompareBench bench(set_of_nobody());
    App& app = bench.program.app;
    bench.load(lines_of_nobody());
    bench.wait_for_comparison();
    for (const Ratings& ratings : app.work.document.set.ratings) {
        CHECK(ratings.mark == NumberMark{.synthetic = true, .left_out = 2, .rehearsals = 1});
    }
    CHECK(contains(bench.program.at("compare:people").value, kLeftOut));
    CHECK(bench.program.at("compare:head rho").value == "synthetic rho");
    const std::string picture = svg_of(app, PictureView::compare);
    CHECK(contains(picture, "left out"));
    CHECK(contains(picture, "synthetic"));
}

TEST_CASE("marked views: tables that are copied carry the same mark" *
          doctest::test_suite("long")) {
    CompareBench bench(set_of_nobody());
    App& app = bench.program.app;
    bench.load(lines_of_nobody());
    bench.wait_for_comparison();
    const std::string metrics = comparison_csv(*app.comparing.comparison);
    for (const char* said : {kLeftOut, "nobody was asked", "trained on synthetic ratings"}) {
        CHECK_MESSAGE(contains(metrics, said), said);
    }
    const auto& map = *app.shown_map.transition.shown;
    CHECK(contains(matrix_csv(map), "trained on synthetic ratings"));
    const auto& rows = candidate_rows(app.work, app.shown_map, app.candidates);
    CHECK(contains(candidates_csv(app.work.document.set, rows), "trained on synthetic ratings"));
}

}  // namespace marked_views_test
