#include "app/map/map.h"

#include <algorithm>
#include <chrono>

#include "tests/support/program.h"

namespace map_follow_test {

using namespace tact;

namespace {

void set_modulation(Program& program, double frequency_hz) {
    edit_patterns(program.app.work,
                  [frequency_hz](Pattern& p) { p.modulation.frequency_hz = frequency_hz; });
}

}  // namespace

TEST_CASE("map: it follows the document, exact in the end") {
    Program program(short_patterns(6));
    CHECK(map_state(program.app.work, program.app.shown_map) == MapState::none);
    program.compute_map();
    CHECK(program.app.shown_map.transition.to.rows() == 6);
    set_modulation(program, 40.0);
    CHECK(map_state(program.app.work, program.app.shown_map) == MapState::stale);
    program.wait_for_exact_map();
    CHECK(program.app.shown_map.transition.shown->request.revision == program.app.work.revision);
}

TEST_CASE("map: until the first one the patterns stand in a ring, and drift to their places") {
    Program program(short_patterns(5));
    CHECK(program.at("map:waiting").value == "5");
    double farthest = 0.0;
    program.after_frame = [&] {
        const MapTransition& map = program.app.shown_map.transition;
        if (map.shown) farthest = std::max(farthest, (map.from - map.to).norm() / map.to.norm());
    };
    for (int k = 0; k < 60; ++k) program.frame();  // long enough to be seen
    program.compute_map();
    CHECK_FALSE(program.shows("map:waiting"));
    CHECK(farthest > 0.5);
}

TEST_CASE("map: its numbers are those of a run on the set alone, whatever was shown before") {
    Program program(short_patterns(7));
    begin_jobs(program.app);
    for (const double hz : {10.0, 70.0, 30.0}) {
        set_modulation(program, hz);
        program.wait_for_exact_map();
    }
    const PatternSet& set = program.app.work.document.set;
    const auto alone = predict(model_waveforms(set), set.model);
    CHECK(program.app.shown_map.transition.shown->prediction.pm == alone->pm);
    const auto space = nonmetric_mds(alone->pm, standard_mds_params(7, 3));
    CHECK(program.app.shown_map.transition.shown->space.stress1 == space.stress1);
    CHECK(program.app.shown_map.transition.shown->space.points == space.points);
}

TEST_CASE("map: undo puts every point back where it was") {
    Program program(short_patterns(6));
    program.compute_map();
    const Eigen::MatrixXd before = program.app.shown_map.transition.to;
    set_modulation(program, 60.0);
    commit_step(program.app.ui, program.app.work, "Change modulation");
    program.wait_for_exact_map();
    undo(program.app.ui, program.app.work);
    program.wait_for_exact_map();
    // Two alignments, there and back, may leave a turn where the shapes differ.
    const double moved = (program.app.shown_map.transition.to - before).norm() / before.norm();
    CHECK(moved <= 0.05);
}

TEST_CASE("map: points ease from where they were to where they are") {
    Program program(short_patterns(5));
    program.compute_map();
    App& app = program.app;
    app.shown_map.transition.since_s = app.ui.time_s;
    app.shown_map.transition.from = Eigen::MatrixXd::Zero(app.shown_map.transition.to.rows(),
                                                          app.shown_map.transition.to.cols());
    CHECK(eased_points(app.ui, app.shown_map) == app.shown_map.transition.from);
    app.ui.time_s += 0.09;
    const double half = eased_points(app.ui, app.shown_map).norm();
    CHECK(half > 0.3 * app.shown_map.transition.to.norm());
    CHECK(half < 0.7 * app.shown_map.transition.to.norm());
    app.ui.time_s += 1.0;
    CHECK(eased_points(app.ui, app.shown_map) == app.shown_map.transition.to);
    app.ui.motion = false;
    app.shown_map.transition.since_s = app.ui.time_s;
    CHECK(eased_points(app.ui, app.shown_map) == app.shown_map.transition.to);
}

TEST_CASE("map: where the exact one has to be asked for, a preview is shown, said to be one") {
    Program program(short_patterns(kMostLivePatterns + 1));
    App& app = program.app;
    begin_jobs(app);
    request_maps(app.ui, app.work, app.shown_map, app.rendered);
    const auto until = end_of_patience();
    while (map_state(app.work, app.shown_map) != MapState::preview) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        program.frame();
    }
    CHECK_FALSE(app.shown_map.full_job.busy());
    program.settle();
    CHECK(program.at("title right:Perceptual space").value == "preview; exact waits");
    CHECK(app.shown_map.transition.to.rows() == kMostLivePatterns + 1);
    const auto preview = app.shown_map.transition.shown;
    program.click("link:compute exact");
    CHECK(app.shown_map.full_job.busy());
    CHECK_FALSE(program.shows("link:compute exact"));
    // It stays, and becomes exact in place: points begin where they stood.
    Eigen::MatrixXd stood = eased_points(app.ui, app.shown_map);
    while (app.shown_map.transition.shown == preview) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        stood = eased_points(app.ui, app.shown_map);
        program.frame();
    }
    const MapTransition& now = app.shown_map.transition;
    CHECK(now.shown->request.preview);
    CHECK(now.shown->exact_share > 0.0);
    CHECK(map_state(app.work, app.shown_map) == MapState::preview);
    CHECK((now.from - stood).norm() < 0.05 * stood.norm());
    CHECK((now.to - stood).norm() < 0.7 * stood.norm());  // a map of its own would be at 1.4
}

TEST_CASE("map: a clip that takes most of the time is named, and taken out by one press") {
    PatternSet set = short_patterns(4);
    for (Vibration& one : set.vibrations) {
        std::get<Pattern>(one.source) = with_duration(std::get<Pattern>(one.source), 3.0);
    }
    std::get<Pattern>(set.vibrations[2].source) =
        with_duration(std::get<Pattern>(set.vibrations[2].source), 60.0);
    for (int k = 0; k < 100; ++k) {
        set.vibrations.push_back(set.vibrations[0]);
        set.vibrations.back().name = "q" + std::to_string(k);
    }
    REQUIRE(needs_asking(set));
    Program program(set);
    CHECK(map_state(program.app.work, program.app.shown_map) != MapState::exact);
    program.app.work.document_number = ++program.app.work.documents;
    program.settle();
    if (!program.shows("link:take out")) {
        begin_jobs(program.app);
        request_maps(program.app.ui, program.app.work, program.app.shown_map, program.app.rendered);
        const auto until = end_of_patience();
        while (!program.shows("link:take out")) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            program.frame();
        }
    }
    program.click("link:take out");
    CHECK(program.app.work.document.set.vibrations.size() == 103);
    CHECK(program.app.work.document.set.vibrations[2].name == "p4");
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == set);
}

TEST_CASE("map: a set that is too large even for a preview waits for a word") {
    Program program(short_patterns(2001));
    begin_jobs(program.app);
    request_maps(program.app.ui, program.app.work, program.app.shown_map, program.app.rendered);
    CHECK_FALSE(program.app.shown_map.full_job.busy());
    CHECK(map_state(program.app.work, program.app.shown_map) == MapState::too_large);
    program.settle();
    CHECK(program.shows("button:compute anyway"));
}

TEST_CASE("map: 2-D is asked for and shown") {
    Program program(short_patterns(6));
    program.compute_map();
    program.click("radio:2-D");
    program.wait_for_exact_map();
    CHECK(program.app.shown_map.transition.to.cols() == 2);
}

TEST_CASE("map: of another set nothing is shown, of an earlier state it is said in both panes") {
    Program program(short_patterns(6));
    program.compute_map();
    App& app = program.app;
    app.layout.bench = BenchTab::matrix;
    app.shown_map.full_job.cancel();
    app.shown_map.maps_asked = ++app.work.revision;  // nobody computes it
    program.settle();
    CHECK(program.at("title right:Perceptual space").value.starts_with("before the edit"));
    CHECK(program.at("title right:Matrix").value.starts_with("before the edit"));
    CHECK(program.shows("matrix selected"));
    app.work.document_number = ++app.work.documents;  // with the same names
    app.of_document = app.work.document_number;       // and whatever a room may still hold
    program.settle();
    CHECK(shows_another_set(app.work, app.shown_map));
    CHECK_FALSE(program.shows("matrix selected"));
    CHECK_FALSE(program.shows("map:closest"));
    CHECK_FALSE(program.shows("point:p1"));
}

}  // namespace map_follow_test
