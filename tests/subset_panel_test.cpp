// The Subset tab in the program's real frames: picks follow the document, and edits are steps.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/bench_follow.h"
#include "app/subset_follow.h"
#include "model/set_subset.h"
#include "program.h"

using namespace tact;

namespace {

struct SubsetBench {
    Program program{short_patterns(9)};
    App& app = program.app;

    SubsetBench() {
        make_jobs(app);
        request_maps(app);
        program.wait_for_exact_map();
        app.bench = BenchTab::subset;
        app.subset->count = 4;
        wait_for_pick();
    }
    ~SubsetBench() { stop_jobs(app); }

    template <class Arrived>
    void wait(const Arrived& arrived) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (!arrived());
        program.settle();
    }

    // Until the subset and the curve are those of the document and the question as they are.
    void wait_for_pick() {
        program.wait_for_exact_map();
        wait([this] {
            const SubsetState& state = *app.subset;
            return state.asked.map == app.map.shown && state.pick &&
                   state.pick->request == state.asked && state.curve &&
                   state.curve->request == state.curve_asked;
        });
    }

    std::size_t members() const {
        return static_cast<std::size_t>(std::ranges::count_if(
            program.places, [](const auto& place) { return place.first.starts_with("member:"); }));
    }
};

}  // namespace

TEST_CASE("subset panel: it shows the model's answer, and a lock changes it as one step") {
    SubsetBench bench;
    App& app = bench.app;
    const Dissimilarity& pm = app.map.shown->prediction.pm;
    const auto best = [&] {
        const SubsetProblem problem =
            subset_problem(app.document.set, static_cast<std::size_t>(app.subset->count),
                           SubsetObjective::max_min);
        return most_distinct_subset(app.map.shown->prediction.pm, problem)->best;
    };
    CHECK(bench.members() == 4);
    REQUIRE(shown_subset(app) != nullptr);
    CHECK(*shown_subset(app) == best());
    CHECK(std::stod(bench.program.at("subset:weakest").value) == best().weakest_dissimilarity);
    CHECK(bench.program.at("subset:proof").value == "Proven: no other subset is better.");

    std::size_t outsider = 0;
    while (std::ranges::binary_search(best().members, outsider)) ++outsider;
    const std::vector<double> before = pm.condensed;
    select_only(app, outsider);
    toggle_locked(app);
    bench.wait_for_pick();
    CHECK(app.map.shown->prediction.pm.condensed == before);  // the model does not see locks
    CHECK(std::ranges::binary_search(shown_subset(app)->members, outsider));
    CHECK(*shown_subset(app) == best());
    toggle_dropped(app);
    bench.wait_for_pick();
    CHECK_FALSE(app.document.set.vibrations[outsider].locked);
    CHECK_FALSE(std::ranges::binary_search(shown_subset(app)->members, outsider));
    undo(app);
    CHECK(app.document.set.vibrations[outsider].locked);
    CHECK_FALSE(app.document.set.vibrations[outsider].dropped);
    undo(app);
    CHECK_FALSE(app.document.set.vibrations[outsider].locked);
    CHECK(app.history.undo_label() == nullptr);
}

TEST_CASE("subset panel: a click into the curve chooses k, a click on an alternative shows it") {
    SubsetBench bench;
    bench.program.click("curve point:6");
    bench.wait_for_pick();
    CHECK(bench.app.subset->count == 6);
    CHECK(bench.members() == 6);
    const auto& alternatives = bench.app.subset->pick->answer.alternatives;
    REQUIRE_FALSE(alternatives.empty());
    bench.app.subset->alternative = 0;
    bench.program.settle();
    CHECK(*shown_subset(bench.app) == alternatives[0]);
    CHECK(std::stod(bench.program.at("subset:weakest").value) ==
          alternatives[0].weakest_dissimilarity);
}

TEST_CASE("subset panel: too close pairs are listed, and a separation is one step of undo") {
    SubsetBench bench;
    App& app = bench.app;
    bench.program.click("subset:Too close");
    app.subset->share = 0.1;
    bench.program.settle();
    const auto& pairs = too_close_pairs(app);
    REQUIRE_FALSE(pairs.pairs.empty());
    CHECK(pairs.pairs.front().dissimilarity <= pairs.threshold);
    const auto& all = app.document.set.vibrations;
    const ConfusablePair pair = pairs.pairs.front();
    CHECK(is_too_close(app, all[pair.a].name));
    bench.program.click("too close:" + all[pair.a].name + "|" + all[pair.b].name);
    bench.program.click("button:separate");
    bench.wait([&] { return !app.subset->separation_job->busy(); });
    const auto found = app.subset->separations;
    REQUIRE(found);
    if (found->all.empty()) return;
    const PatternSet before = app.document.set;
    const std::size_t changed = found->request.changed;
    bench.program.click("apply:0");
    CHECK(app.document.set != before);
    const auto& pattern = std::get<Pattern>(app.document.set.vibrations[changed].source);
    CHECK(value_of(pattern, found->all[0].parameter) == found->all[0].to);
    bench.program.wait_for_exact_map();
    const Dissimilarity& pm = app.map.shown->prediction.pm;
    double nearest = 1e300;
    for (std::size_t k = 0; k < pm.size; ++k) {
        if (k != changed) nearest = std::min(nearest, pm(changed, k));
    }
    CHECK(nearest == found->all[0].nearest);
    CHECK(nearest > found->request.threshold);
    undo(app);
    CHECK(app.document.set == before);
}

TEST_CASE("subset panel: models are drawn on request, and the map has an ellipse for each point") {
    SubsetBench bench;
    bench.program.click("subset:How sure");
    bench.app.subset->stability_job->submit({bench.app.subset->pick, 4});
    bench.wait([&] { return shown_stability(bench.app) != nullptr; });
    const Stability& stability = *shown_stability(bench.app);
    CHECK(stability.draws == 4);
    CHECK(stability.spread.size() == 9);
    CHECK(bench.program.shows("subset:stability"));
    CHECK(bench.program.shows("stability:" + bench.app.document.set.vibrations[0].name) ==
          (stability.share_picked[0] > 0.0 ||
           std::ranges::binary_search(stability.subset.members, std::size_t{0})));
}
