// Words about the raters stand beside every number that is made of their ratings.

#include "app/compare/compare.h"

#include <doctest/doctest.h>

#include "tests/support/compare_bench.h"
#include "tests/support/run_program.h"

namespace people_text_test {

using namespace tact;

namespace {

// Ratings by two participants of the first `rated` of six patterns.
std::string lines_csv(int rated, bool synthetic) {
    std::string lines = "participant,a,b,rating,synthetic\n";
    for (int person = 1; person <= 2; ++person) {
        for (int i = 1; i <= rated; ++i) {
            for (int j = i + 1; j <= rated; ++j) {
                lines += "P" + std::to_string(person) + ",p" + std::to_string(i) + ",p" +
                         std::to_string(j) + "," +
                         std::to_string(7 * i % 5 + 3 * j + person * (i % 2)) +
                         (synthetic ? ",1\n" : ",0\n");
            }
        }
    }
    return lines;
}

}  // namespace

TEST_CASE(
    "compare tab: beside every number made from ratings nobody gave stands that they are none" *
    doctest::test_suite("long")) {
    CompareBench bench;
    bench.load(lines_csv(6, true));
    bench.wait_for_comparison();
    const auto shown = [&bench](const char* name) { return bench.program.at(name).value; };
    CHECK(contains(shown("compare:people"), "2 participants, synthetic: nobody was asked"));
    CHECK(contains(shown("compare:ceiling"), "synthetic rho"));
    CHECK(shown("compare:head rho") == "synthetic rho");
    CHECK(shown("compare:head K") == "synthetic K");
    bench.program.click("compare:Pairs");
    CHECK(contains(shown("view:Pairs"), "synthetic rated dissimilarity, synthetic rho"));
    bench.program.click("tab:Shepard");
    bench.program.click("combo:metric");
    bench.program.click("choose:ratings");
    CHECK(contains(shown("view:Shepard"), "dissimilarity by synthetic ratings"));
    bench.program.click("check:overlay ratings");
    CHECK(contains(shown("overlay"), "synthetic: nobody was asked"));
    bench.program.app.layout.bench = BenchTab::compare;
    bench.program.app.comparing.panel.view = CompareView::table;
    bench.load(lines_csv(6, false));
    bench.wait_for_comparison();
    for (const char* name : {"compare:people", "compare:ceiling", "compare:head rho", "overlay"}) {
        CHECK_FALSE(contains(shown(name), "synthetic"));
    }
}

TEST_CASE("compare tab: who of several is none does not count, and that stays with the ratings") {
    CompareBench bench;
    std::string lines = "participant,a,b,rating,synthetic,excluded\n";
    for (const char* marks : {"P1 0,0", "P2 1,0", "P3 0,1"}) {
        for (const char* pair : {"p1,p2,10", "p1,p3,40", "p2,p3,70"}) {
            lines += std::string(marks, 2) + "," + pair + "," + (marks + 3) + "\n";
        }
    }
    bench.load(lines);
    bench.wait_for_comparison();
    CHECK(contains(bench.program.at("compare:people").value,
                   "people.csv (2 participants left out): 1 participant, 3 of 6 patterns rated"));
}

TEST_CASE("compare tab: patterns nobody rated are told at once, and named beside the numbers") {
    CompareBench bench;
    bench.load(lines_csv(4, false));
    const std::string unrated = "2 of 6 patterns were not rated and are left out: \"p5\", \"p6\"";
    CHECK(contains(bench.program.app.ui.status.text, unrated));
    bench.wait_for_comparison();
    CHECK(bench.program.at("compare:unrated").value == unrated);
    CHECK(contains(bench.program.at("compare:people").value, "4 of 6 patterns rated"));
}

TEST_CASE(
    "compare tab: the ceiling is the one for a metric, and what one person reaches is said "
    "to be that") {
    Reliability agreement;
    agreement.voices = 18;
    agreement.spearman_brown = 0.81;
    agreement.ceiling_of_mean = 0.9;
    agreement.one_with_others = 0.55;
    CHECK(ceiling_text(agreement, {}) ==
          "Noise ceiling: a metric can reach rho 0.90 with the mean of 18 participants "
          "(reliability 0.81); one participant reaches 0.55 with the mean of the others.");
    agreement.is_of_one_person = true;
    CHECK(contains(ceiling_text(agreement, {.synthetic = true}),
                   "synthetic rho 0.90 with the mean of one "
                   "person's 18 repetitions"));
}

TEST_CASE("compare tab: each ceiling says what it bounds, in the text and beside the points") {
    CompareBench bench;
    bench.load(lines_csv(6, false));
    bench.wait_for_comparison();
    const std::string said = bench.program.at("compare:ceiling").value;
    CHECK(contains(said, "a metric can reach rho "));
    CHECK(contains(said, "With one participant the best metric there could be has a mean rho of "));
    CHECK(contains(said, "of each with the mean of the others, and with that of all."));
    bench.program.click("compare:Pairs");
    CHECK(contains(bench.program.at("view:Pairs").value, ", at most "));
    CHECK(single_ceiling_text({}, {}).empty());
}

TEST_CASE(
    "overlay: what nobody rated has no ring, and the others lie where they would without it") {
    CompareBench bench;
    App& app = bench.program.app;
    bench.load(lines_csv(4, false));
    bench.wait_for_comparison();
    bench.program.click("check:overlay ratings");
    const auto over = people_over_map(app.shown_map, app.comparing);
    REQUIRE(over);
    REQUIRE(over->rows() == 6);
    CHECK(over->bottomRows(2).array().isNaN().all());
    const Eigen::MatrixXd placed = over->topRows(4);
    REQUIRE(placed.allFinite());
    // The fit uses the four alone: no shift is left.
    const Eigen::MatrixXd map = app.shown_map.transition.to.topRows(4);
    CHECK((placed.colwise().mean() - map.colwise().mean()).norm() <= 1e-9);
    CHECK(contains(bench.program.at("overlay").value, "4 of 6 patterns rated"));
}

}  // namespace people_text_test
