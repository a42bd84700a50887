// One number of several patterns: shown as mixed if they differ, and moved together.

#include "tests/support/typed_numbers.h"

namespace mixed_numbers_test {

using namespace tact;

namespace {

// Strengths of 1, 2 and 0.5 g, modulated at 0, 5 and 10 Hz; all selected, the first is current.
PatternSet three() {
    PatternSet set = odd_numbers(3);
    const double strengths_g[] = {1.0, 2.0, 0.5};
    for (std::size_t k = 0; k < 3; ++k) {
        auto& pattern = std::get<Pattern>(set.vibrations[k].source);
        pattern.amplitude_g = strengths_g[k];
        pattern.modulation.frequency_hz = 5.0 * static_cast<double>(k);
    }
    return set;
}

struct ThreeSelected : Program {
    explicit ThreeSelected(const PatternSet& set = three()) : Program(set) {
        app.work.selection.others = {1, 2};
        settle();
    }

    void check_strengths(double a_g, double b_g, double c_g) const {
        CHECK(pattern(0).amplitude_g == doctest::Approx(a_g).epsilon(1e-9));
        CHECK(pattern(1).amplitude_g == doctest::Approx(b_g).epsilon(1e-9));
        CHECK(pattern(2).amplitude_g == doctest::Approx(c_g).epsilon(1e-9));
    }

    void slide(const char* slider, float by_px) {
        const Place bar = at(slider);
        window.move(bar.middle());
        window.button(true);
        settle();
        for (const float share : {0.5F, 1.0F}) {
            window.move(bar.middle() + ImVec2{share * by_px, 0.0F});
            settle();
        }
        window.button(false);
        settle();
    }
};

}  // namespace

TEST_CASE("mixed numbers: where the selected differ the entry says so, and only there") {
    ThreeSelected program;
    CHECK(program.at("entry:amplitude_g").value == "mixed");
    CHECK(program.at("entry:modulation_hz").value == "mixed");
    CHECK(program.at("entry:carrier_1_hz").value != "mixed");
    program.click("row:p2");
    CHECK(program.at("entry:amplitude_g").value != "mixed");
}

TEST_CASE("mixed numbers: looked at and left they stay as they are") {
    ThreeSelected program;
    program.click("entry:amplitude_g");
    program.press_key(key::kEnter);
    program.check_strengths(1.0, 2.0, 0.5);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("mixed numbers: a typed number becomes that of all, the current one's own as well") {
    ThreeSelected program;
    enter(program, "entry:amplitude_g", "1");
    program.check_strengths(1.0, 1.0, 1.0);
    CHECK(program.at("entry:amplitude_g").value != "mixed");
    program.press('z', true);
    program.check_strengths(1.0, 2.0, 0.5);
}

TEST_CASE("mixed numbers: a typed change is of each one's own number") {
    ThreeSelected program;
    enter(program, "entry:amplitude_g", "*2");
    program.check_strengths(2.0, 4.0, 1.0);
    enter(program, "entry:amplitude_g", "-10%");
    program.check_strengths(1.8, 3.6, 0.9);
    enter(program, "entry:amplitude_g", "+20dB");
    program.check_strengths(18.0, 36.0, 9.0);
}

TEST_CASE("mixed numbers: what could not follow out of its range is said") {
    ThreeSelected program;
    enter(program, "entry:amplitude_g", "*40");
    program.check_strengths(40.0, 50.0, 20.0);
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.ui.status.text.find("1 of 3 patterns") != std::string::npos);
    CHECK(program.app.ui.status.text.find("50 g") != std::string::npos);
}

TEST_CASE("mixed numbers: a drag keeps the proportions, through its lowest point too") {
    ThreeSelected program;
    program.slide("slider:amplitude_g", -200.0F);  // beyond its left end
    program.press('z', true);
    program.check_strengths(1.0, 2.0, 0.5);
    const Place bar = program.at("slider:amplitude_g");
    program.window.move(bar.middle());
    program.window.button(true);
    program.settle();
    for (const float x : {bar.min.x - 50.0F, bar.min.x + 0.6F * (bar.max.x - bar.min.x)}) {
        program.window.move({x, bar.middle().y});
        program.settle();
    }
    program.window.button(false);
    program.settle();
    const double to_g = program.pattern(0).amplitude_g;
    CHECK(to_g > 2.0);
    // Rounded to the nearest hundredth, the step of sliders.
    CHECK(program.pattern(1).amplitude_g == doctest::Approx(2.0 * to_g).epsilon(0.005));
    CHECK(program.pattern(2).amplitude_g == doctest::Approx(0.5 * to_g).epsilon(0.005));
    program.press('z', true);
    program.check_strengths(1.0, 2.0, 0.5);
}

TEST_CASE("mixed numbers: where one is 0 a drag moves all by the same difference") {
    ThreeSelected program;
    program.slide("slider:modulation_hz", 20.0F);
    const double by_hz = program.pattern(0).modulation.frequency_hz;
    CHECK(by_hz > 0.0);
    CHECK(program.pattern(1).modulation.frequency_hz == doctest::Approx(5.0 + by_hz).epsilon(1e-9));
    CHECK(program.pattern(2).modulation.frequency_hz ==
          doctest::Approx(10.0 + by_hz).epsilon(1e-9));
}

TEST_CASE("mixed numbers: arrows step each, and Esc brings each one's own back") {
    ThreeSelected program;
    program.click("entry:amplitude_g");
    program.press_key(key::kUp);
    program.press_key(key::kUp);
    program.check_strengths(1.1, 2.1, 0.6);
    program.press_key(key::kEscape);
    program.check_strengths(1.0, 2.0, 0.5);
    program.press_key(key::kRight);
    program.check_strengths(1.05, 2.05, 0.55);
}

TEST_CASE("mixed numbers: a double click on the label resets all") {
    ThreeSelected program;
    for (int k = 0; k < 2; ++k)
        program.window.click(program.at("field label:amplitude_g").middle());
    program.settle();
    const double normal_g = Pattern{}.amplitude_g;
    program.check_strengths(normal_g, normal_g, normal_g);
}

TEST_CASE("mixed numbers: a locked one neither counts nor moves") {
    PatternSet set = three();
    set.vibrations[1].locked = true;
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 1.0;
    ThreeSelected program(set);
    CHECK(program.at("entry:amplitude_g").value != "mixed");
    enter(program, "entry:amplitude_g", "*3");
    program.check_strengths(3.0, 2.0, 3.0);
}

}  // namespace mixed_numbers_test
