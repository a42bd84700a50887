#include "app/map/map_follow.h"

#include "app/window/jobs.h"
#include "tests/support/program.h"

namespace map_follow_test {

using namespace tact;

namespace {

void set_modulation(Program& program, double frequency_hz) {
    edit_patterns(program.app,
                  [frequency_hz](Pattern& p) { p.modulation.frequency_hz = frequency_hz; });
}

}  // namespace

TEST_CASE("map: it follows the document, exact in the end") {
    Program program(short_patterns(6));
    CHECK(map_state(program.app) == MapState::none);
    make_jobs(program.app);
    request_maps(program.app);
    program.wait_for_exact_map();
    CHECK(program.app.map.to.rows() == 6);
    set_modulation(program, 40.0);
    CHECK(map_state(program.app) == MapState::stale);
    program.wait_for_exact_map();
    CHECK(program.app.map.shown->request.revision == program.app.revision);
}

TEST_CASE("map: its numbers are those of a run on the set alone, whatever was shown before") {
    Program program(short_patterns(7));
    make_jobs(program.app);
    for (const double hz : {10.0, 70.0, 30.0}) {
        set_modulation(program, hz);
        program.wait_for_exact_map();
    }
    const PatternSet& set = program.app.document.set;
    const auto alone = predict(model_waveforms(set), set.model);
    CHECK(program.app.map.shown->prediction.pm == alone->pm);
    const auto space = nonmetric_mds(alone->pm, standard_mds_params(7, 3));
    CHECK(program.app.map.shown->space.stress1 == space.stress1);
    CHECK(program.app.map.shown->space.points == space.points);
}

TEST_CASE("map: undo puts every point back where it was") {
    Program program(short_patterns(6));
    make_jobs(program.app);
    request_maps(program.app);
    program.wait_for_exact_map();
    const Eigen::MatrixXd before = program.app.map.to;
    set_modulation(program, 60.0);
    commit_step(program.app, "Change modulation");
    program.wait_for_exact_map();
    undo(program.app);
    program.wait_for_exact_map();
    // Two alignments, there and back, may leave a turn where the shapes differ.
    const double moved = (program.app.map.to - before).norm() / before.norm();
    CHECK(moved <= 0.05);
}

TEST_CASE("map: points ease from where they were to where they are") {
    Program program(short_patterns(5));
    make_jobs(program.app);
    request_maps(program.app);
    program.wait_for_exact_map();
    App& app = program.app;
    app.map.since_s = app.time_s;
    app.map.from = Eigen::MatrixXd::Zero(app.map.to.rows(), app.map.to.cols());
    CHECK(eased_points(app) == app.map.from);
    app.time_s += 0.09;
    const double half = eased_points(app).norm();
    CHECK(half > 0.3 * app.map.to.norm());
    CHECK(half < 0.7 * app.map.to.norm());
    app.time_s += 1.0;
    CHECK(eased_points(app) == app.map.to);
    app.motion = false;
    app.map.since_s = app.time_s;
    CHECK(eased_points(app) == app.map.to);
}

TEST_CASE("map: a very large set waits for a word") {
    Program program(short_patterns(kMostLivePatterns + 1));
    make_jobs(program.app);
    request_maps(program.app);
    CHECK_FALSE(program.app.full_job->busy());
    CHECK(map_state(program.app) == MapState::too_large);
    program.settle();
    CHECK(program.shows("button:compute anyway"));
}

TEST_CASE("map: 2-D is asked for and shown") {
    Program program(short_patterns(6));
    make_jobs(program.app);
    request_maps(program.app);
    program.wait_for_exact_map();
    program.click("radio:2-D");
    program.wait_for_exact_map();
    CHECK(program.app.map.to.cols() == 2);
}

}  // namespace map_follow_test
