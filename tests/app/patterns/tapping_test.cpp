// A rhythm is tapped, by T and by the mouse.

#include <cmath>

#include "tests/support/program.h"

namespace tapping_test {

using namespace tact;

namespace {

struct Tapping : Program {
    double time_s = 0.0;

    Tapping() : Program(short_patterns(2)) {
        auto& set = app.work.document.edit();
        for (Vibration& vibration : set.vibrations) {
            std::get<Pattern>(vibration.source).duration_s = 1.0;
        }
        document_changed(app.work);
        commit_step(app.ui, app.work, "Prepare");
        settle();
    }
    const Pattern& pattern(std::size_t k = 0) const {
        return std::get<Pattern>(app.work.document.set.vibrations[k].source);
    }
    // Draws frames until this time after the first one.
    void wait_until(double since_s) {
        while (window.now_s < time_s + since_s) frame();
    }
    // T opens the dialog, and is still held when it opens.
    void open() {
        push(window.input, {window.now_s, KeyChange{'T', true, false, U't'}});
        settle();
        push(window.input, {window.now_s, KeyChange{'T', false, false, U't'}});
        settle();
    }
    void hold(double from_s, double to_s, int code = 'T', char32_t sign = U't') {
        if (time_s == 0.0) time_s = window.now_s;
        wait_until(from_s);
        push(window.input, {window.now_s, KeyChange{code, true, false, sign}});
        wait_until(to_s);
        push(window.input, {window.now_s, KeyChange{code, false, false, sign}});
        frame();
    }
};

}  // namespace

TEST_CASE("tapping: T opens it and is no tap then, Enter takes what T and Space tapped") {
    Tapping program;
    program.open();
    CHECK(program.app.ui.dialog == kTappingDialog);
    CHECK(program.at("tap").value == "0");
    program.hold(0.0, 0.28);
    program.hold(0.5, 0.65, key::kSpace, U' ');
    program.hold(0.75, 0.9);
    program.settle();
    CHECK(program.at("tap").value == "3");
    program.press_key(key::kEnter);
    CHECK(program.app.ui.dialog == kNoDialog);
    const Rhythm& rhythm = program.pattern().rhythm;
    CHECK(rhythm.unit_s == doctest::Approx(0.125).epsilon(0.1));
    CHECK(rhythm.text.starts_with("x=--x-x"));
    CHECK(program.pattern().duration_s == 1.0);
    CHECK(*program.app.work.document.history.undo_label() == "Tap rhythm of p1");
    CHECK(program.pattern(1).rhythm.text.empty());
}

TEST_CASE("tapping: a longer rhythm makes a longer pattern, in one step that is undone") {
    Tapping program;
    program.open();
    for (int k = 0; k < 4; ++k) program.hold(0.6 * k, 0.6 * k + 0.3);
    program.settle();
    program.press_key(key::kEnter);
    CHECK(program.pattern().duration_s > 1.9);
    undo(program.app.ui, program.app.work);
    CHECK(program.pattern().duration_s == 1.0);
    CHECK(program.pattern().rhythm.text.empty());
}

TEST_CASE("tapping: another step is typed, and what is typed is no tap") {
    Tapping program;
    program.open();
    for (int k = 0; k < 3; ++k) program.hold(0.4 * k, 0.4 * k + 0.15);
    program.settle();
    program.click("entry:tap_step_ms");
    program.type("t100");
    program.press_key(key::kTab);
    CHECK(program.at("tap").value == "3");
    program.click("entry:tap_step_ms");
    program.type("100");
    program.press_key(key::kEnter);
    CHECK(program.at("tapped").value.starts_with("x"));
    CHECK(program.app.work.document.history.undo_label() != nullptr);
    CHECK(program.app.ui.dialog == kTappingDialog);
    program.click("button:choose");
    CHECK(program.pattern().rhythm.unit_s == doctest::Approx(0.1));
}

TEST_CASE("tapping: the mouse taps as well, and Esc leaves the pattern as it was") {
    Tapping program;
    program.press(U't');
    program.click("link:start over");
    const ImVec2 pad = program.at("tap").middle();
    program.window.click(pad);
    program.settle();
    program.window.click(pad);
    program.settle();
    CHECK(program.at("tap").value == "2");
    const Pattern before = program.pattern();
    program.press_key(key::kEscape);
    CHECK(program.app.ui.dialog == kNoDialog);
    CHECK(program.pattern() == before);
}

TEST_CASE("tapping: T is a letter in a text field, and nothing for a locked pattern") {
    Tapping program;
    program.app.work.document.edit().vibrations[0].locked = true;
    program.settle();
    program.press(U't');
    CHECK(program.app.ui.dialog == kNoDialog);
}

}  // namespace tapping_test
