// A rhythm that is longer than its pattern, in the editor.
#include "tests/support/program.h"

namespace rhythm_fields_test {

using namespace tact;

namespace {

const Pattern& shown(const Program& program) {
    return std::get<Pattern>(current_vibration(program.app.work)->source);
}

void give_rhythm(Program& program, const std::string& text, double unit_s) {
    edit_patterns(program.app.work, [&](Pattern& pattern) {
        pattern.rhythm = {text, unit_s};
        pattern.duration_s = 1.0;
    });
    commit_step(program.app.ui, program.app.work, "rhythm");
    program.settle();
}

}  // namespace

TEST_CASE("rhythm: steps behind the end are told, and one press lengthens the pattern to them") {
    Program program(short_patterns(2));
    program.resize({1600.0F, 1600.0F}, 1.0F);  // the whole editor is visible
    give_rhythm(program, "x-x-x-x-x-x-x-x-", 0.125);
    const PatternSet before = program.app.work.document.set;
    CHECK(program.at("rhythm:overrun").value == "Plays 8 of 16 steps");
    CHECK(program.at("link:lengthen").value == "Lengthen to 2 s");
    program.click("link:lengthen");
    CHECK(shown(program).duration_s == 2.0);
    CHECK(!program.shows("rhythm:overrun"));
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
    // A rhythm that fits or repeats has no remark; a pattern cannot be lengthened beyond a minute.
    give_rhythm(program, "x-x-", 0.25);
    CHECK(!program.shows("rhythm:overrun"));
    give_rhythm(program, "x-x-x-x-", 10.0);
    CHECK(program.at("rhythm:overrun").value == "Plays 1 of 8 steps");
    program.click("link:lengthen");
    CHECK(shown(program).duration_s == 60.0);
}

TEST_CASE("rhythm: a letter has its strength and pitch below, and beats and bars are numbers") {
    Program program(short_patterns(2));
    program.resize({1600.0F, 1600.0F}, 1.0F);
    give_rhythm(program, "A-x-", 0.125);
    const auto type = [&](const char* entry, const char* text) {
        program.click(std::string("entry:") + entry);
        program.type(text);
        program.press_key(key::kEnter);
        program.settle();
    };
    type("kind_strength_A", "40");
    type("kind_pitch_A", "2");
    CHECK(kind_of(shown(program).rhythm, 'A') == NoteKind{0.4, 2.0});
    CHECK(!program.shows("entry:kind_pitch_B"));
    type("steps_a_beat", "2");
    type("beats_a_bar", "3");
    CHECK(shown(program).rhythm.meter == Meter{2, 3});
    CHECK(shown(program).rhythm.unit_s == 0.125);  // another way to count leaves the step's length
    type("tempo_bpm", "120");
    CHECK(shown(program).rhythm.unit_s == 0.25);
    undo(program.app.ui, program.app.work);
    CHECK(shown(program).rhythm.unit_s == 0.125);
}

TEST_CASE("rhythm: dragged up or down, a step's note is weaker or as strong as it can be") {
    Program program(short_patterns(2));
    give_rhythm(program, "x-x=x---", 0.125);
    const auto dragged = [&](const std::string& step, float by_px) {
        const ImVec2 at = program.at(step).middle();
        program.drag(at, {at.x, at.y + by_px}, 3);
        return shown(program).rhythm.text;
    };
    const PatternSet before = program.app.work.document.set;
    CHECK(dragged("step:2", 20.0F) == "x-5=x---");
    CHECK(dragged("step:2", -10.0F) == "x-7=x---");
    CHECK(dragged("step:2", -300.0F) == "x-x=x---");
    CHECK(dragged("step:0", 300.0F) == "1-x=x---");
    for (int k = 0; k < 4; ++k) undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
    // A click turns a weaker note into a rest if no step holds it.
    give_rhythm(program, "5-", 0.125);
    program.click("step:0");
    CHECK(shown(program).rhythm.text == "--");
}

TEST_CASE("rhythm: one of thousands of steps is edited as text, and says so") {
    Program program(short_patterns(2));
    std::string text;
    for (int k = 0; k < 1000; ++k) text += "x-";
    give_rhythm(program, text, 0.001);
    CHECK(program.at("rhythm:long").value == "2,000 steps: edit the text, or notes in the strip");
    CHECK(!program.shows("step:0"));
}

}  // namespace rhythm_fields_test
