// One playhead and one time axis in all plots of the physiology pane.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/physiology_program.h"

namespace physiology_time_test {

using namespace tact;

TEST_CASE("physiology: all time axes begin and end at the same pixels, small and large") {
    PhysiologyProgram program;
    const auto check = [&](const std::string& stage, std::vector<std::string> rows) {
        program.click("stage:" + stage);
        const Place first = program.at("plot:" + rows[0]);
        for (const std::string& row : rows) {
            CHECK(program.at("plot:" + row).min.x == first.min.x);
            CHECK(program.at("plot:" + row).max.x == first.max.x);
        }
    };
    check("all", {"vibration", "filtered FA1", "filtered SA2", "raster", "central FA2", "brain",
                  "envelope"});
    check("filtered", {"filtered FA1", "filtered FA2", "filtered SA2"});
}

TEST_CASE("physiology: a press in any plot moves the one playhead, dragging scrubs") {
    PhysiologyProgram program;
    program.drag(program.in_row("brain", 0.2F), program.in_row("brain", 0.7F), 3);
    CHECK(std::abs(program.app.timeline.playhead.at_s - 0.07) < 0.002);
    program.drag(program.in_row("vibration", 0.5F), program.in_row("vibration", 0.3F), 3);
    CHECK(std::abs(program.app.timeline.playhead.at_s - 0.03) < 0.002);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE(
    "physiology: Ctrl and wheel zoom where the mouse is, the wheel moves on, all views follow" *
    doctest::test_suite("long")) {
    PhysiologyProgram program;
    for (int k = 0; k < 5; ++k) program.wheel(program.in_row("envelope", 0.5F), 1.0F, true);
    const TimeRange zoomed_in = program.app.timeline.range;
    CHECK(zoomed_in.length_s() < 0.05);
    CHECK(std::abs(0.5 * (zoomed_in.start_s + zoomed_in.end_s) - 0.05) < 0.002);
    program.wheel(program.in_row("raster", 0.5F), -1.0F, false);
    CHECK(program.app.timeline.range.start_s > zoomed_in.start_s);
    CHECK(std::abs(program.app.timeline.range.length_s() - zoomed_in.length_s()) < 1e-12);
    for (int k = 0; k < 40; ++k) program.wheel(program.in_row("brain", 0.5F), 1.0F, true);
    CHECK(std::abs(program.app.timeline.range.length_s() - 0.005) < 1e-9);
    program.click("show all");
    CHECK(program.app.timeline.range == TimeRange{});
    CHECK(std::abs(shown_range(program.app.timeline, 0.1).length_s() - 0.1) < 1e-12);
}

TEST_CASE("physiology: Space plays and halts, at the chosen speed, and Esc stops") {
    PhysiologyProgram program;
    program.click("speed:1/100");
    program.window.press(key::kSpace, U' ');
    program.settle();
    CHECK(program.app.timeline.playhead.playing);
    const double from_s = program.app.timeline.playhead.at_s;
    for (int k = 0; k < 50; ++k) program.frame();
    const double moved_s = program.app.timeline.playhead.at_s - from_s;
    CHECK(std::abs(moved_s - 50 * 0.01 * program.window.frame_s) < 1e-9);
    program.press_key(key::kEscape);
    CHECK_FALSE(program.app.timeline.playhead.playing);
    const double stopped_s = program.app.timeline.playhead.at_s;
    for (int k = 0; k < 5; ++k) program.frame();
    CHECK(program.app.timeline.playhead.at_s == stopped_s);
    program.press('.');
    CHECK(std::abs(program.app.timeline.playhead.at_s -
                   (std::floor(stopped_s / 0.005) + 1) * 0.005) < 1e-12);
}

}  // namespace physiology_time_test
