// While thresholds are shifted, the map without that stays as ghosts.
#include "app/map/parts.h"

#include "model/physiology/neural_coding.h"
#include "tests/support/program.h"

namespace unshifted_map_test {

using namespace tact;

namespace {

void shift_pacinian(Program& program, double decades) {
    Workspace& work = program.app.work;
    Curve& curve = work.document.edit().model.coding.tables.threshold[index_of(Receptor::pacinian)];
    for (double& value : curve.value) value += decades;
    model_changed(work);
    commit_step(program.app.ui, work, "Shift");
    program.wait_for_exact_map();
}

void wait_for_ghosts(Program& program) {
    const auto until = end_of_patience();
    while (!shows_unshifted(program.app.shown_map.transition)) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.frame();
}

}  // namespace

TEST_CASE("unshifted map: ghosts stay where the points were until the threshold is as it comes") {
    Program program(short_patterns(6));
    program.compute_map();
    const ShownMap& map = program.app.shown_map;
    const Eigen::MatrixXd before = map.transition.to;
    CHECK_FALSE(program.shows("unshifted"));
    shift_pacinian(program, 1.0);
    for (int k = 0; k < 3; ++k) {
        program.window.now_s += 10.0;  // long after ghosts of an edit have faded
        program.frame();
    }
    CHECK(program.shows("unshifted"));
    CHECK(map.transition.ghost == before);
    CHECK(ghost_opacity(program.app.ui, map) == 1.0);
    CHECK((map.transition.to - before).norm() > 0.01 * before.norm());
    // A second shift is held against the same.
    shift_pacinian(program, 0.5);
    CHECK(map.transition.ghost == before);
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    program.wait_for_exact_map();
    program.window.now_s += 10.0;
    program.settle();
    CHECK_FALSE(program.shows("unshifted"));
    CHECK(ghost_opacity(program.app.ui, map) == 0.0);
    CHECK((map.transition.to - before).norm() <= 1e-6 * before.norm());
}

TEST_CASE("unshifted map: of a set that was opened with shifted thresholds it is made") {
    PatternSet set = short_patterns(6);
    Program whole(set);
    whole.compute_map();
    const Dissimilarity unshifted = whole.app.shown_map.transition.shown->prediction.pm;
    for (double& value : set.model.coding.tables.threshold[index_of(Receptor::pacinian)].value) {
        value += 1.0;
    }
    Program program(set);
    program.compute_map();
    wait_for_ghosts(program);
    const MapTransition& map = program.app.shown_map.transition;
    CHECK(map.anchor->prediction.pm == unshifted);
    CHECK(map.shown->prediction.pm != unshifted);
    CHECK(map.ghost.allFinite());
    // And again if a pattern is edited meanwhile.
    edit_patterns(program.app.work, [](Pattern& p) { p.modulation.frequency_hz = 40.0; });
    program.wait_for_exact_map();
    wait_for_ghosts(program);
    CHECK(map.anchor->prediction.pm != unshifted);
}

}  // namespace unshifted_map_test
