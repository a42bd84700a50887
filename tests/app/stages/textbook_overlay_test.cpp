// The textbook over the stages: switched on, remembered, with the model's deviations.
#include <doctest/doctest.h>

#include "app/window/window.h"
#include "tests/support/physiology_program.h"

namespace textbook_overlay_test {

using namespace tact;

namespace {

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("textbook over the stages: off at first, signs small, lines large, by mouse and key") {
    PhysiologyProgram program;
    CHECK_FALSE(program.shows("textbook:spikes"));
    program.click("textbook");
    program.settle();
    CHECK(holds(program.at("textbook:spikes").value, "Freeman & Johnson 1982, monkey"));
    CHECK(holds(program.at("textbook:spikes").value, "\u2260 Textbook: "));
    // No facts were measured for the vibration itself, or for its envelope.
    CHECK_FALSE(program.shows("textbook:vibration"));
    CHECK_FALSE(program.shows("textbook:envelope"));
    program.app.physiology.view.open = Stage::receptors;
    program.settle();
    CHECK(holds(program.at("textbook:receptors").value, "Johansson & Vallbo 1979, human"));
    CHECK_FALSE(holds(program.at("textbook:receptors").value, "from memory"));
    program.press('e');
    program.settle();
    CHECK_FALSE(program.shows("textbook:receptors"));
}

TEST_CASE("textbook over the stages: what it says is left out of the remark above it") {
    PhysiologyProgram program;
    program.app.physiology.view.open = Stage::spikes;
    program.settle();
    REQUIRE(program.shows("remark:spikes"));
    CHECK(holds(program.at("remark:spikes").value, "Impulses a cycle"));
    program.press('e');
    program.settle();
    CHECK(holds(program.at("textbook:spikes").value, "impulse a cycle"));
    if (program.shows("remark:spikes")) {
        CHECK_FALSE(holds(program.at("remark:spikes").value, "Impulses a cycle"));
    }
}

TEST_CASE("textbook over the stages: the switch is remembered, and stays with another document") {
    PhysiologyProgram program;
    program.app.physiology.view.textbook = true;
    keep_layout(program.app);
    program.app.physiology.view.textbook = false;
    restore_layout(program.app);
    CHECK(program.app.physiology.view.textbook);
    program.app.work.document.open({short_patterns(2), {}, short_patterns(2)});
    ++program.app.work.document_number;
    ++program.app.work.revision;
    program.settle();
    CHECK(program.app.physiology.view.textbook);
}

}  // namespace textbook_overlay_test
