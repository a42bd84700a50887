// The Why tab, through the program's real frames.
#include <cmath>

#include "model/text/numbers.h"
#include "tests/support/compare_bench.h"

namespace why_panel_test {

using namespace tact;

TEST_CASE("why tab: it explains the current pattern and its closest one, or the one clicked") {
    CompareBench bench;
    App& app = bench.program.app;
    bench.program.click("tab:Why");
    bench.wait_for_difference();
    auto pair = chosen_pair(app.work, app.shown_map);
    CHECK(pair->kind == PartnerKind::closest);
    const Dissimilarity& pm = app.shown_map.transition.shown->prediction.pm;
    for (std::size_t k = 1; k < kRatedPatterns; ++k) CHECK(pm(0, pair->partner) <= pm(0, k));
    choose_pair(app.work, 1, 3);
    bench.wait_for_difference();
    CHECK(bench.program.at("why:pair").value == "p2|p4");
    const std::size_t k = pair_index(kRatedPatterns, 1, 3);
    const Prediction& prediction = app.shown_map.transition.shown->prediction;
    const double share = prediction.nc_rank[k] / (prediction.nc_rank[k] + prediction.oc_rank[k]);
    CHECK(contains(bench.program.at("why:parts").value, "neural coding " + percent(share)));
    // The steps' mean is NC squared.
    double mean = 0.0;
    for (const double step : app.comparing.difference->apart) mean += step;
    mean /= static_cast<double>(app.comparing.difference->apart.size());
    const double nc = prediction.nc.condensed[k];
    CHECK(std::abs(mean - nc * nc) <= 1e-12);
    CHECK(bench.program.at("why:seconds").min.y > bench.program.at("plot:why path").min.y);
    bench.program.click("link:both pipelines");
    CHECK(app.work.selection.pinned == "p4");
}

TEST_CASE("why tab: a part in which two do not differ has no share, though ties have a rank") {
    Prediction prediction;
    prediction.nc.condensed = {0.0, 0.0, 2.0, 1.0};
    prediction.oc.condensed = {3.0, 0.0, 1e-15, 1.0};  // one of them by rounding noise
    prediction.nc_rank = {1.5, 1.5, 4.0, 3.0};
    prediction.oc_rank = {4.0, 1.5, 1.5, 3.0};
    prediction.params.nc_weight = 1.0;
    prediction.params.oc_weight = 3.0;
    CHECK(part_shares(prediction, 0).nc == 0.0);
    CHECK(part_shares(prediction, 0).oc == 1.0);
    CHECK(part_shares(prediction, 1).nc == 0.0);
    CHECK(part_shares(prediction, 1).oc == 0.0);
    CHECK(part_shares(prediction, 2).nc == 1.0);
    CHECK(part_shares(prediction, 3).nc == 0.25);
    CHECK(part_shares(prediction, 3).oc == 0.75);
}

TEST_CASE("why tab: it says whether people notice what two single carriers differ in") {
    PatternSet set = short_patterns(4);
    const double hz[] = {40.0, 250.0, 44.0, 40.0};
    for (std::size_t k = 0; k < 4; ++k) {
        Pattern& pattern = std::get<Pattern>(set.vibrations[k].source);
        pattern.carriers = {{.frequency_hz = hz[k]}};
        pattern.amplitude_g = 1.0;
    }
    std::get<Pattern>(set.vibrations[3].source).carriers.push_back({.frequency_hz = 90.0});
    CompareBench bench(set);
    bench.program.click("tab:Why");
    const auto said_of = [&](std::size_t a, std::size_t b) {
        choose_pair(bench.program.app.work, a, b);
        bench.wait_for_difference();
        return bench.program.shows("why:noticed") ? bench.program.at("why:noticed").value
                                                  : std::string();
    };
    CHECK(
        contains(said_of(0, 1), "40 against 250 Hz, 6.25 times; people tell these apart at once"));
    CHECK(contains(said_of(0, 2), "most people do not notice that"));
    CHECK_FALSE(contains(said_of(0, 2), "forgotten"));
    CHECK(said_of(0, 3).empty());  // no remark for several carriers
}

TEST_CASE("why tab: a cell of the matrix makes the pair") {
    CompareBench bench;
    const ImVec2 middle = bench.program.at("view:Matrix").middle();
    ImVec2 cell = middle;
    for (float away = 0.0F; away < 150.0F && !bench.program.shows("pair"); away += 10.0F) {
        cell = middle - ImVec2{away, 0.0F};
        bench.program.hover(cell);
    }
    const std::string names = bench.program.at("pair").value;  // "p4   p2", then numbers
    bench.program.window.click(cell);
    bench.program.settle();
    bench.program.click("tab:Why");
    const std::string pair = bench.program.at("why:pair").value;
    CHECK(pair == names.substr(0, 2) + "|" + names.substr(5, 2));
}

}  // namespace why_panel_test
