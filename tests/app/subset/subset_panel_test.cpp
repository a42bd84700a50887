// The Subset tab in the program's real frames: picks follow the document, and edits are steps.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "app/compare/compare.h"
#include "app/subset/subset.h"
#include "model/export/loss_words.h"
#include "model/subset/set_subset.h"
#include "model/tasks/set_pairs.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace subset_panel_test {

using namespace tact;

namespace {

struct SubsetBench {
    Program program{short_patterns(9)};
    App& app = program.app;

    SubsetBench() {
        program.compute_map();
        app.layout.bench = BenchTab::subset;
        app.picking.count = 4;
        app.picking.too_close = TooClose::share;  // by felt steps none of these is
        wait_for_pick();
    }

    template <class Arrived>
    void wait(const Arrived& arrived) {
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (!arrived());
        program.settle();
    }

    // Waits until the subset and the curve are those of the present document and question.
    void wait_for_pick() {
        program.wait_for_exact_map();
        wait([this] {
            const SubsetState& state = app.picking;
            return state.asked.map == app.shown_map.transition.shown && state.pick &&
                   state.pick->request == state.asked && !is_picking(state) && state.curve &&
                   state.curve->request == state.curve_asked;
        });
    }

    std::size_t members() const {
        return static_cast<std::size_t>(std::ranges::count_if(
            program.places, [](const auto& place) { return place.first.starts_with("member:"); }));
    }
};

}  // namespace

TEST_CASE("subset panel: another count and the curve go by the matrix of the first pick") {
    SubsetBench bench;
    SubsetState& picking = bench.app.picking;
    picking.metric = Metric::rmse;
    bench.wait_for_pick();
    const auto matrix = picking.pick->dissimilarity;
    CHECK(*matrix == set_pairs(bench.app.work.document.set, {Metric::rmse, false})->apart);
    CHECK(picking.curve_job.asked()->apart == matrix);
    picking.count = 5;
    picking.objective = SubsetObjective::max_sum;
    bench.wait_for_pick();
    CHECK(picking.pick->request.problem.count == 5);
    CHECK(picking.pick->dissimilarity == matrix);
    picking.metric = Metric::spqi;
    bench.wait_for_pick();
    CHECK(picking.pick->dissimilarity != matrix);
    CHECK(picking.curve_job.asked()->apart == picking.pick->dissimilarity);
}

TEST_CASE("subset panel: it shows the model's answer, and a lock changes it as one step") {
    SubsetBench bench;
    App& app = bench.app;
    const Dissimilarity& pm = app.shown_map.transition.shown->prediction.pm;
    const auto best = [&] {
        const SubsetProblem problem =
            subset_problem(app.work.document.set, static_cast<std::size_t>(app.picking.count),
                           SubsetObjective::max_min);
        return most_distinct_subset(app.shown_map.transition.shown->prediction.pm, problem)->best;
    };
    CHECK(bench.members() == 4);
    REQUIRE(shown_subset(app.shown_map, app.picking) != nullptr);
    CHECK(*shown_subset(app.shown_map, app.picking) == best());
    CHECK(std::stod(bench.program.at("subset:weakest").value) == best().weakest_dissimilarity);
    CHECK(bench.program.at("subset:proof").value ==
          "Proven: in no other subset is the weakest pair farther apart.");

    std::size_t outsider = 0;
    while (std::ranges::binary_search(best().members, outsider)) ++outsider;
    const std::vector<double> before = pm.condensed;
    select_only(app.work, outsider);
    toggle_locked(app.ui, app.work);
    bench.wait_for_pick();
    CHECK(app.shown_map.transition.shown->prediction.pm.condensed ==
          before);  // the model does not see locks
    CHECK(std::ranges::binary_search(shown_subset(app.shown_map, app.picking)->members, outsider));
    CHECK(*shown_subset(app.shown_map, app.picking) == best());
    toggle_dropped(app.ui, app.work);
    bench.wait_for_pick();
    CHECK_FALSE(app.work.document.set.vibrations[outsider].locked);
    CHECK_FALSE(
        std::ranges::binary_search(shown_subset(app.shown_map, app.picking)->members, outsider));
    undo(app.ui, app.work);
    CHECK(app.work.document.set.vibrations[outsider].locked);
    CHECK_FALSE(app.work.document.set.vibrations[outsider].dropped);
    undo(app.ui, app.work);
    CHECK_FALSE(app.work.document.set.vibrations[outsider].locked);
    CHECK(app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("subset panel: a click into the curve chooses k, a click on an alternative shows it") {
    SubsetBench bench;
    bench.program.click("curve point:6");
    bench.wait_for_pick();
    CHECK(bench.app.picking.count == 6);
    CHECK(bench.members() == 6);
    const auto& alternatives = bench.app.picking.pick->answer.alternatives;
    REQUIRE_FALSE(alternatives.empty());
    bench.app.picking.alternative = 0;
    bench.program.settle();
    CHECK(*shown_subset(bench.app.shown_map, bench.app.picking) == alternatives[0]);
    CHECK(std::stod(bench.program.at("subset:weakest").value) ==
          alternatives[0].weakest_dissimilarity);
}

TEST_CASE("subset panel: the chosen count says how far apart its weakest pair is") {
    SubsetBench bench;
    bench.program.hover({0.0F, 0.0F});
    CHECK(bench.program.at("curve chosen").value ==
          loss_number(std::stod(bench.program.at("subset:weakest").value)));
}

TEST_CASE("subset panel: a member has the menu that every pattern has") {
    SubsetBench bench;
    Program& program = bench.program;
    const auto member = std::ranges::find_if(
        program.places, [](const auto& place) { return place.first.starts_with("member:"); });
    REQUIRE(member != program.places.end());
    const std::string name = member->first.substr(std::string("member:").size());
    program.hover(program.at("member:" + name).middle());
    program.window.button(true, 1);
    program.settle();
    program.window.button(false, 1);
    program.settle();
    for (const char* row : {"Play", "Rename", "Exclude", "Duplicate", "Find similar", "Vary"}) {
        CHECK(program.shows(std::string("row menu:") + row));
    }
    program.click("row menu:Lock");
    const auto place = place_named(bench.app.work.document.set, name);
    REQUIRE(place);
    CHECK(bench.app.work.document.set.vibrations[*place].locked);
    CHECK(bench.app.work.document.history.undo_label() != nullptr);
}

TEST_CASE("subset panel: too close pairs are listed, and a separation is one step of undo") {
    SubsetBench bench;
    App& app = bench.app;
    bench.program.click("subset:Too close");
    app.picking.share = 0.005;  // the closest pair: there is room for it elsewhere
    bench.program.settle();
    const auto& pairs = too_close_pairs(app.shown_map, app.picking);
    REQUIRE_FALSE(pairs.pairs.empty());
    CHECK(pairs.pairs.front().dissimilarity <= pairs.threshold);
    const auto& all = app.work.document.set.vibrations;
    const ConfusablePair pair = pairs.pairs.front();
    CHECK(too_close_names(app.layout, app.picking).contains(all[pair.a].name));
    bench.program.click("too close:" + all[pair.a].name + "|" + all[pair.b].name);
    bench.program.click("button:separate");
    bench.wait([&] { return !app.picking.separation_job.busy(); });
    const auto found = app.picking.separations;
    REQUIRE(found);
    REQUIRE_FALSE(found->all.empty());
    const PatternSet before = app.work.document.set;
    const std::size_t changed = found->request.changed;
    bench.program.click("apply:0");
    CHECK(app.work.document.set != before);
    const auto& pattern = std::get<Pattern>(app.work.document.set.vibrations[changed].source);
    CHECK(value_of(pattern, found->all[0].parameter) == found->all[0].to);
    bench.program.wait_for_exact_map();
    const Dissimilarity& pm = app.shown_map.transition.shown->prediction.pm;
    double nearest = 1e300;
    for (std::size_t k = 0; k < pm.size; ++k) {
        if (k != changed) nearest = std::min(nearest, pm(changed, k));
    }
    CHECK(nearest == found->all[0].nearest);
    CHECK(nearest > found->request.threshold);
    undo(app.ui, app.work);
    CHECK(app.work.document.set == before);
}

TEST_CASE("subset panel: by felt steps no pair is too close, until two differ by none") {
    SubsetBench bench;
    App& app = bench.app;
    CHECK(SubsetState{}.too_close == TooClose::felt);
    bench.program.click("subset:Too close");
    bench.program.click("radio:Felt step");
    CHECK(bench.program.at("too close").value.find("differ by a felt step") != std::string::npos);
    CHECK(too_close_names(app.layout, app.picking).empty());
    Pattern twin = bench.program.pattern(0);
    twin.amplitude_g *= 1.1;
    app.work.document.edit().vibrations[1].source = twin;
    document_changed(app.work);
    commit_step(app.ui, app.work, "Change the second");
    bench.wait_for_pick();
    CHECK(bench.program.shows("too close:p1|p2"));
    bench.program.click("too close:p1|p2");
    bench.program.click("button:separate");
    bench.wait([&] { return !app.picking.separation_job.busy(); });
    const auto found = app.picking.separations;
    REQUIRE(found);
    REQUIRE_FALSE(found->all.empty());
    for (const Separation& one : found->all) CHECK(one.steps >= 1.0 - 1e-9);
    bench.program.click("apply:0");
    bench.wait_for_pick();
    CHECK_FALSE(bench.program.shows("too close:p1|p2"));
    CHECK(app.ui.status.text.find("no longer too close") != std::string::npos);
    CHECK_FALSE(app.ui.status.is_error);
}

TEST_CASE("subset panel: what would separate the weakest pair is asked in one click") {
    SubsetBench bench;
    App& app = bench.app;
    const Subset before = *shown_subset(app.shown_map, app.picking);
    const auto name = [&](std::size_t row) { return app.work.document.set.vibrations[row].name; };
    bench.program.click("link:separate pair");
    CHECK(app.picking.view == SubsetView::confusable);
    CHECK(app.picking.too_close == TooClose::picked);
    CHECK(opened_rows(app.shown_map, app.picking) == before.weakest);
    CHECK(bench.program.shows("too close:" + name(before.weakest.first) + "|" +
                              name(before.weakest.second)));
    bench.wait([&] { return !app.picking.separation_job.busy(); });
    const auto found = app.picking.separations;
    REQUIRE(found);
    CHECK(found->request.from == before.members);
    CHECK(found->request.threshold >= before.weakest_dissimilarity);
    REQUIRE_FALSE(found->all.empty());
    for (const Separation& one : found->all) {
        CHECK(std::ranges::binary_search(before.members, one.nearest_to));
    }
    bench.program.click("apply:0");
    bench.wait_for_pick();
    CHECK_FALSE(opened_rows(app.shown_map, app.picking) == std::nullopt);
    undo(app.ui, app.work);
    CHECK(app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("subset panel: whatever cannot be asked says why") {
    SubsetBench bench;
    App& app = bench.app;
    bench.program.click("subset:Too close");
    const auto& all = app.work.document.set.vibrations;
    const ConfusablePair pair = too_close_pairs(app.shown_map, app.picking).pairs.front();
    bench.program.click("too close:" + all[pair.a].name + "|" + all[pair.b].name);
    CHECK_FALSE(bench.program.shows("separation obstacle"));
    app.shown_map.maps_asked = ++app.work.revision;  // as in the middle of a drag
    bench.program.settle();
    CHECK(bench.program.at("separation obstacle").value ==
          "It can be asked once the map is exact.");
    bench.program.click("button:separate");
    CHECK_FALSE(app.picking.separation_job.busy());
    bench.program.click("subset:Pick");
    CHECK(bench.program.at("subset:proof").value.starts_with("From before the last change"));
    bench.program.click("subset:Too close");
    app.shown_map.maps_asked = --app.work.revision;

    app.work.document.edit().vibrations[pair.a].locked = true;
    bench.program.settle();
    CHECK(bench.program.at("radio:change first").value == all[pair.a].name + "  (locked)");
    CHECK_FALSE(bench.program.shows("separation obstacle"));
    CHECK(row_to_change(app.work, app.shown_map, app.picking, {pair.a, pair.b}) == pair.b);
    app.work.document.edit().vibrations[pair.b].locked = true;
    bench.program.settle();
    CHECK(bench.program.at("separation obstacle").value ==
          "Neither may be changed: unlock one of them (Ctrl+L).");

    bench.program.click("subset:How sure");
    CHECK_FALSE(bench.program.shows("stability obstacle"));
    app.picking.metric = Metric::nc;
    bench.wait_for_pick();
    CHECK(bench.program.at("stability obstacle").value ==
          "Only a subset picked by PM hangs on the model's numbers.");
}

TEST_CASE("subset panel: the weakest pair can be played from where it is named") {
    SubsetBench bench;
    App& app = bench.app;
    bench.program.click("link:play pair");
    CHECK(app.timeline.playhead.playing);
    CHECK(app.work.selection.current == shown_subset(app.shown_map, app.picking)->weakest.first);
    CHECK(app.work.selection.partner ==
          app.work.document.set.vibrations[shown_subset(app.shown_map, app.picking)->weakest.second]
              .name);
    CHECK(bench.program.at("link:play pair").value == "Stop");
    bench.program.click("link:play pair");
    CHECK_FALSE(app.timeline.playhead.playing);
}

TEST_CASE("subset panel: models are drawn on request, and the map has an ellipse for each point") {
    SubsetBench bench;
    bench.program.click("subset:How sure");
    ask_for_stability(bench.app.ui, bench.app.picking, 4);
    bench.wait([&] { return shown_stability(bench.app.picking) != nullptr; });
    const Stability& stability = *shown_stability(bench.app.picking);
    CHECK(stability.draws == 4);
    CHECK(stability.moves.size() == 9);
    CHECK(bench.program.shows("subset:stability"));
    CHECK(bench.program.shows("stability:" + bench.app.work.document.set.vibrations[0].name) ==
          (stability.share_picked[0] > 0.0 ||
           std::ranges::binary_search(stability.subset.members, std::size_t{0})));
}

TEST_CASE("subset panel: ellipses are gone with an edit, and are there again once it is undone") {
    SubsetBench bench;
    App& app = bench.app;
    bench.program.click("subset:How sure");
    ask_for_stability(app.ui, app.picking, 4);
    bench.wait([&] { return shown_stability(app.picking) != nullptr; });
    const auto moves = shown_stability(app.picking)->moves;
    edit_patterns(app.work, [](Pattern& pattern) { pattern.carriers[0].frequency_hz = 333.0; });
    commit_step(app.ui, app.work, "frequency");
    bench.wait([&] { return shown_stability(app.picking) == nullptr; });
    bench.wait([&] { return !is_pick_stale(app.work, app.shown_map, app.picking); });
    CHECK(shown_stability(app.picking) == nullptr);
    undo(app.ui, app.work);
    bench.wait([&] { return shown_stability(app.picking) != nullptr; });
    CHECK(shown_stability(app.picking)->moves == moves);
    bench.wait([&] {
        return subset_marks(app.ui.theme, app.layout, app.shown_map, app.picking).spread == moves;
    });
}

TEST_CASE("subset panel: a report waits for the subset of the set as it is, whatever tab is open") {
    SubsetBench bench;
    App& app = bench.app;
    const TemporaryFolder folder;
    const auto written = [&](const std::filesystem::path& file) {
        return [&app, file] {
            continue_subset_export(app.ui, app.work, app.shown_map, app.picking);  // after a frame
            return std::filesystem::exists(file);
        };
    };
    app.layout.bench = BenchTab::matrix;
    app.picking.count = 3;  // nobody looks, so nobody has picked three
    export_report(app.ui, app.picking, folder.path / "page");
    bench.wait(written(folder.path / "page.html"));
    CHECK(app.picking.report_to.empty());
    const std::string page = bytes_of(folder.path / "page.html");
    CHECK(page.find("<h2>The 3 most distinct</h2>") != std::string::npos);
    CHECK(page.find("the weakest pair of the 3 most distinct, proven") != std::string::npos);
    for (const std::string& name : names_of(app.work.document.set)) {
        CHECK(page.find(name) != std::string::npos);
    }
    // A pair that the person took for a measure decides.
    app.picking.too_close = TooClose::reference;
    app.picking.reference_a = app.work.document.set.vibrations[0].name;
    app.picking.reference_b = app.work.document.set.vibrations[1].name;
    export_report(app.ui, app.picking, folder.path / "other.html");
    bench.wait(written(folder.path / "other.html"));
    CHECK(bytes_of(folder.path / "other.html").find("the reference pair that was taken") !=
          std::string::npos);
}

TEST_CASE("subset panel: by the sum, every sentence and every value is of the sum") {
    SubsetBench bench;
    App& app = bench.app;
    Program& program = bench.program;
    select_only(app.work, 0);
    toggle_locked(app.ui, app.work);
    select_only(app.work, 5);
    toggle_locked(app.ui, app.work);
    program.click("radio:Sum");
    bench.wait_for_pick();
    program.hover({0.0F, 0.0F});
    const Pick& pick = *app.picking.pick;
    REQUIRE(pick.request.problem.objective == SubsetObjective::max_sum);
    CHECK(std::stod(program.at("subset:sum").value) == pick.answer.best.sum);
    CHECK_FALSE(program.shows("subset:weakest"));
    CHECK(program.at("subset:proof").value == "Proven: no other subset has a larger sum.");
    const auto& others = pick.answer.alternatives;
    REQUIRE_FALSE(others.empty());
    for (std::size_t k = 0; k < others.size(); ++k) {
        CAPTURE(k);
        const std::string words = program.at("alternative:" + std::to_string(k + 1)).value;
        const std::string value = words.substr(words.rfind(": ") + 2);
        CHECK(others[k].sum <= pick.answer.best.sum);
        CHECK(value ==
              (others[k].sum == pick.answer.best.sum ? "ties" : loss_number(others[k].sum)));
    }
    // Another one that is looked at shows its own sum.
    app.picking.alternative = 0;
    program.settle();
    CHECK(std::stod(program.at("subset:sum").value) == others[0].sum);
}

TEST_CASE("subset panel: a number that locks or the set do not allow is refused in a sentence") {
    SubsetBench bench;
    App& app = bench.app;
    const auto fault_with = [&](int count) {
        app.picking.count = count;
        bench.wait([&] {
            return app.picking.pick && app.picking.pick->request == app.picking.asked &&
                   !is_picking(app.picking) &&
                   app.picking.asked.problem.count == static_cast<std::size_t>(count);
        });
        bench.program.settle();
        CHECK(bench.members() == 0);
        // The model says it, and says it everywhere so.
        const auto said = check_subset(app.picking.asked.problem, 9);
        REQUIRE_FALSE(said);
        CHECK(bench.program.at("subset:fault").value == said.error().message + ".");
        return bench.program.at("subset:fault").value;
    };
    CHECK(fault_with(10) == "10 to pick of 9: expected at most as many.");
    for (Vibration& one : app.work.document.edit().vibrations) one.locked = true;
    document_changed(app.work);
    bench.program.wait_for_exact_map();
    CHECK(fault_with(3) == "3 to pick, but 9 must be kept.");
}

TEST_CASE("subset panel: who has not said how many gets 8, or as many as there are") {
    Program program(short_patterns(5));
    App& app = program.app;
    program.compute_map();
    app.layout.bench = BenchTab::subset;
    const auto until = end_of_patience();
    while ((!app.picking.pick || is_picking(app.picking)) &&
           std::chrono::steady_clock::now() < until)
        program.frame();
    REQUIRE(app.picking.pick);
    CHECK(app.picking.count == 5);
    CHECK(app.picking.pick->answer.best.members.size() == 5);
}

TEST_CASE("subset panel: what nobody feels is none of the most distinct, unless it is included") {
    PatternSet set = short_patterns(6);
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 0.0;
    Program program(set);
    App& app = program.app;
    program.compute_map();
    REQUIRE(
        (unfelt(app.shown_map.transition.shown->prediction.codes) == std::vector<std::size_t>{2}));
    app.layout.bench = BenchTab::subset;
    const auto pick = [&] {
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (!app.picking.pick || app.picking.pick->request != app.picking.asked ||
                 app.picking.asked.map != app.shown_map.transition.shown ||
                 is_subset_busy(app.picking));
        program.settle();
    };
    pick();
    CHECK(app.picking.count == 5);
    CHECK_FALSE(program.shows("member:p3"));
    CHECK(program.at("subset:unfelt").value.starts_with("1 not felt pattern left out"));
    // What is proven is of the same candidates: so is the curve.
    CHECK(app.picking.curve->points.back().count == 5);
    program.click("link:include unfelt");
    app.picking.count = 6;
    program.frame();
    pick();
    CHECK(program.shows("member:p3"));
    CHECK(program.shows("member not felt:p3"));
    CHECK(program.at("subset:unfelt").value == "1 not felt may be picked.");
    // Whoever is locked is picked in any case.
    program.click("link:include unfelt");
    app.work.document.edit().vibrations[2].locked = true;
    document_changed(app.work);
    program.wait_for_exact_map();
    pick();
    CHECK(program.shows("member:p3"));
    CHECK_FALSE(program.shows("subset:unfelt"));
}

}  // namespace subset_panel_test
