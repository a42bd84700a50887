// All results belong to the named document: no result, selection or text of one document is shown
// after another has replaced it, even if both have patterns with the same names.
#include <doctest/doctest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/subset/subset.h"
#include "tests/support/scene_steps.h"

namespace another_document_test {

using namespace tact;

namespace {

using Shown = std::map<std::string, std::string>;  // noted items, by the view they are in

PatternSet weaker_patterns(double duration_s, std::size_t count = 6) {
    PatternSet set = short_patterns(count);
    set.name = "another set";
    for (Vibration& one : set.vibrations) {
        std::get<Pattern>(one.source).amplitude_g = 0.3;
        std::get<Pattern>(one.source).duration_s = duration_s;
    }
    return set;
}

void open(Program& program, const PatternSet& set) {
    App& app = program.app;
    // A menu would open it in the middle of a frame, too.
    app.ui.waiting.push_back([&app, set] {
        show_document(app.ui, app.work, {set, {}, set}, "Opened " + set.name + ".");
    });
    program.settle();
}

struct View {
    std::string name;
    std::function<void(App&)> show;
};

std::vector<View> views() {
    std::vector<View> all;
    const auto bench = [&all](const std::string& name, BenchTab tab, auto also) {
        all.push_back({name, [tab, also](App& app) {
                           app.layout.bench = tab;
                           also(app);
                       }});
    };
    for (const BenchRow& row : kBenchTabs) {
        // These two are looked at view by view, below.
        if (row.tab == BenchTab::subset || row.tab == BenchTab::compare) continue;
        bench(row.key, row.tab, [](App&) {});
    }
    for (const SubsetView view :
         {SubsetView::pick, SubsetView::confusable, SubsetView::stability, SubsetView::groups})
        bench("subset " + std::to_string(static_cast<int>(view)), BenchTab::subset,
              [view](App& app) { app.picking.view = view; });
    for (const CompareView view : {CompareView::table, CompareView::scatter})
        bench("compare " + std::to_string(static_cast<int>(view)), BenchTab::compare,
              [view](App& app) { app.comparing.panel.view = view; });
    bench("training", BenchTab::model,
          [](App& app) { app.model_bench.panel.view = ModelView::training; });
    return all;
}

// Some view has asked, and is not answered yet.
bool is_answer_due(const App& app) {
    const Comparing& comparing = app.comparing;
    return is_subset_busy(app.picking) || app.rendered.job.busy() ||
           comparing.comparison_job.busy() || comparing.difference_job.busy() ||
           comparing.fit_job.busy() || app.physiology.stages_job.busy() ||
           app.physiology.pinned_job.busy() || app.work.cache.behind;
}

// All items of the window, view by view and arrangement by arrangement.
Shown everything(Program& program) {
    Shown shown;
    for (const Arrangement arrangement :
         {Arrangement::design, Arrangement::select, Arrangement::physiology}) {
        program.app.layout.arrangement = arrangement;
        for (const View& view : views()) {
            view.show(program.app);
            program.settle();
            // A view may ask for its own answer, which an earlier look has already fetched.
            wait_until(program, [&] { return !is_answer_due(program.app); });
            const std::string in =
                view.name + " " + std::to_string(static_cast<int>(arrangement)) + "/";
            for (const auto& [name, place] : program.places) shown[in + name] = place.value;
        }
    }
    return shown;
}

void wait_for_waves(Program& program) {
    wait_until(program, [&] { return !program.app.work.cache.behind; });
}

// Uses everything that a person can use.
void work_on(Program& program) {
    App& app = program.app;
    program.compute_map();
    app.shown_map.show_people = true;
    app.shown_map.look.colour = PatternParameter::carrier;
    app.shown_map.look.path = PatternParameter::modulation;
    app.shown_map.look.filter = PatternParameter::carrier;
    app.shown_map.look.passes = {0.0, 100.0};
    app.shown_map.look.clusters = 3;
    app.shown_map.camera.zoom = 3.0;
    app.shown_map.move_tool = true;
    app.picking.count = 4;
    app.picking.objective = SubsetObjective::max_sum;
    app.picking.too_close = TooClose::share;
    app.picking.share = 0.2;
    app.picking.opened = {"p1", "p2"};
    show_subset(program, SubsetView::pick);
    wait_until(program, [&] {
        return app.picking.curve && !is_subset_busy(app.picking) && !app.picking.pick->fault.size();
    });
    app.picking.alternative = 0;
    ask_for_stability(app.ui, app.picking, 2);
    wait_until(program, [&] { return !app.picking.stabilities.empty(); });
    show_compare(program, CompareView::table);
    wait_for_comparison(program);
    show_why(program);
    show_bench(program, BenchTab::shepard);
    show_bench(program, BenchTab::device);
    show_bench(program, BenchTab::candidates);
    app.timeline.range = {0.0, 0.03};
    app.timeline.playhead.at_s = 0.02;
    app.work.selection.search = "p";
    app.work.selection.only_picked = true;
    app.work.selection.pinned = "p3";
    app.steps.from = "p1";
    app.steps.to = "p2";
    app.pad.corners = {"p1", "p2"};
    app.proposals.varied = "p1";
    app.generating.begun = true;
    app.play.felt_on_hover = "p1";
    app.ui.dialog = kPadDialog;
    program.settle();
}

Shown after(bool has_worked, const PatternSet& set,
            const std::function<void(Program&)>& wait_for_it) {
    Program program(short_patterns(9));
    program.app.ui.motion = false;
    begin_jobs(program.app);
    if (has_worked) work_on(program);
    open(program, set);
    wait_for_it(program);
    Shown shown = everything(program);
    return shown;
}

void check_alike(const Shown& with, const Shown& without) {
    CHECK_FALSE(without.empty());
    for (const auto& [name, value] : with) {
        // The time it took differs from run to run.
        if (value.find("computed in") != std::string::npos) continue;
        const auto found = without.find(name);
        CHECK_MESSAGE(found != without.end(), name << " is left of the document before: " << value);
        if (found == without.end()) continue;
        CHECK_MESSAGE(found->second == value, name << " says what it said before");
    }
    for (const auto& [name, value] : without) CHECK_MESSAGE(with.contains(name), name);
}

}  // namespace

TEST_CASE("another document: without a map of it, nothing of the one before is on screen" *
          doctest::test_suite("long")) {
    // The set shares names with the first, and has more patterns than a preview can have.
    const PatternSet set = weaker_patterns(0.05, 2001);
    REQUIRE(needs_asking(set));
    REQUIRE_FALSE(preview_grain(set));
    check_alike(after(true, set, wait_for_waves), after(false, set, wait_for_waves));
}

TEST_CASE("another document: once it is computed, the window is as if it had been the first" *
          doctest::test_suite("long")) {
    const PatternSet set = weaker_patterns(0.1);
    const auto computed = [](Program& program) {
        App& app = program.app;
        program.wait_for_exact_map();
        show_subset(program, SubsetView::pick);
        wait_until(program, [&] { return app.picking.curve && !is_subset_busy(app.picking); });
        show_compare(program, CompareView::table);
        wait_for_comparison(program);
        show_bench(program, BenchTab::why);
        wait_until(program, [&] { return app.comparing.difference != nullptr; });
        show_bench(program, BenchTab::shepard);
        wait_until(program, [&] { return app.comparing.panel.fit != nullptr; });
        show_bench(program, BenchTab::device);
        wait_until(program, [&] { return app.rendered.shown != nullptr; });
        program.wait_for_stages();
        wait_for_waves(program);
    };
    check_alike(after(true, set, computed), after(false, set, computed));
}

TEST_CASE("another document: what is asked for is of its number, and an earlier answer is none") {
    Program program(short_patterns(4));
    App& app = program.app;
    program.compute_map();
    const auto before = app.shown_map.transition.shown;
    CHECK(before->request.document == app.work.document_number);
    open(program, short_patterns(4));  // equal to the first, but another document
    CHECK(app.work.document_number != before->request.document);
    CHECK(app.shown_map.transition.shown != before);
    program.wait_for_exact_map();
    CHECK(app.shown_map.transition.shown->request.document == app.work.document_number);
}

TEST_CASE("another document: the whole of a short pattern in view is the whole of a long one") {
    Program program(short_patterns(3));
    program.settle();
    CHECK_FALSE(program.shows("bar:range"));
    PatternSet longer = short_patterns(3);
    longer.duration_s = 0.3;
    std::get<Pattern>(longer.vibrations[0].source).duration_s = 0.3;
    open(program, longer);
    CHECK_FALSE(program.shows("bar:range"));
    CHECK(shown_range(program.app.timeline, 0.3).end_s == 0.3);
    program.app.timeline.range = {0.1, 0.2};
    program.settle();
    CHECK(program.shows("bar:range"));
    new_document(program.app.ui, program.app.work);
    open(program, longer);
    CHECK_FALSE(program.shows("bar:range"));
}

TEST_CASE("another document: a map under way outlives a lesson, and is not asked for twice") {
    Program program(weaker_patterns(60.0));
    App& app = program.app;
    begin_jobs(app);
    request_maps(app.ui, app.work, app.shown_map, app.rendered);
    wait_until(program, [&] { return program.shows("link:compute exact"); });
    program.click("link:compute exact");
    wait_until(program, [&] { return app.shown_map.full_job.busy(); });
    const LiveMapRequest asked = *app.shown_map.full_job.asked();
    const std::uint64_t document = app.work.document_number;
    app.timeline.range = {0.0, 0.5};
    open_tour(program);
    CHECK(app.work.document_number != document);
    const auto& of_lesson = app.shown_map.full_job.asked();
    CHECK((!of_lesson || of_lesson->document != asked.document));
    CHECK(app.aside.shown_map.full_job.busy());
    leave_lesson(lesson_context(app), app.lesson);
    program.settle();
    CHECK(app.work.document_number == document);
    CHECK(is_same_work(asked, *app.shown_map.full_job.asked()));  // so that it does not start again
    CHECK(app.shown_map.full_job.busy());
    CHECK(map_state(app.work, app.shown_map) != MapState::too_large);
    CHECK(app.timeline.range == TimeRange{0.0, 0.5});
    // A new document has a number that no earlier document or lesson had.
    open(program, short_patterns(2));
    CHECK(app.work.document_number > document + 1);
}

}  // namespace another_document_test
