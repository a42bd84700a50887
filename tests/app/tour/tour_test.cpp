// The guided tour, in the program's real frames.
#include <doctest/doctest.h>

#include "app/tour/tour.h"
#include "tests/support/program.h"

namespace tour_test {

using namespace tact;

namespace {

struct Tour : ProgramWithStages {
    Tour() : ProgramWithStages(short_patterns(3)) {}
};

}  // namespace

TEST_CASE("tour: it goes from start to end, and leaves the document and the view as they were") {
    Tour program;
    program.app.timeline.range = {0.0, 0.05};
    program.app.physiology.view.open = Stage::envelope;
    program.frame();
    program.click("start tour");
    for (std::size_t step = 1; step < tour_steps().size(); ++step) {
        REQUIRE(program.app.tour.step == step - 1);
        program.click("tour:next");
        for (int k = 0; k < 3; ++k) program.frame();
    }
    program.wait_for_stages();
    CHECK(program.shows("plot:brain pinned"));
    program.click("tour:finish");
    CHECK_FALSE(program.shows("tour"));
    CHECK(program.app.physiology.view.open == Stage::envelope);
    CHECK(program.app.timeline.range == TimeRange{0.0, 0.05});
    CHECK(program.app.work.document.set == short_patterns(3));
    CHECK(program.app.work.history.undo_label() == nullptr);
    CHECK(program.app.tour.left_at == 0);
}

TEST_CASE("tour: left half way, it is taken up there") {
    Tour program;
    program.click("start tour");
    for (int k = 0; k < 4; ++k) program.click("tour:next");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("tour"));
    program.click("start tour");
    CHECK(program.app.tour.step == 4U);
    CHECK(program.app.physiology.view.open == Stage::receptors);
}

}  // namespace tour_test
