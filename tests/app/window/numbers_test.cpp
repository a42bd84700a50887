// Typing, stepping and nudging the numbers of the window.

#include <array>

#include "app/study/study.h"
#include "app/window/window.h"
#include "tests/support/program.h"
#include "tests/support/typed_numbers.h"

namespace numbers_test {

using namespace tact;

namespace {

bool says(const Program& program, const char* part) {
    return program.app.ui.status.text.find(part) != std::string::npos;
}

std::string undo_label(const Program& program) {
    const std::string* label = program.app.work.document.history.undo_label();
    return label == nullptr ? "" : *label;
}

// Types into those that are present and can be clicked, and leaves them by Enter; returns their
// number.
std::size_t try_all(Program& program, const std::vector<std::string>& entries,
                    const std::string& text) {
    std::size_t tried = 0;
    for (const std::string& entry : entries) {
        if (!program.shows(entry)) continue;
        CAPTURE(entry);
        CAPTURE(text);
        const std::string before = program.at(entry).value;
        const PatternSet set = program.app.work.document.set;
        // At its left: some have buttons at their right.
        program.window.click({program.at(entry).min.x + 8.0F, program.at(entry).middle().y});
        program.settle();
        if (program.app.ui.field.typing.entry == 0) continue;  // scrolled away, or disabled
        ++tried;
        program.app.ui.status = {};
        program.type(text);
        program.press_key(key::kEnter);
        CHECK(program.at(entry).value == before);
        CHECK(program.app.work.document.set == set);
        CHECK(program.app.ui.status.is_error);
        CHECK(says(program, "no number"));
    }
    return tried;
}

std::vector<std::string> shown_entries(const Program& program) {
    std::vector<std::string> entries;
    for (const auto& [name, place] : program.places) {
        if (name.starts_with("entry:")) entries.push_back(name);
    }
    return entries;
}

void window_click(Program& program, const char* name) {
    program.window.click(program.at(name).middle());
}

constexpr std::array<const char*, 4> kNoNumbers{"nan", "inf", "-inf", "1e999"};

}  // namespace

TEST_CASE("numbers: the present value typed again leaves it, and is no undo step") {
    Program program(odd_numbers(2));
    enter(program, "entry:amplitude_g", "1.5");
    enter(program, "entry:carrier_1_hz", "180");
    enter(program, "entry:modulation_hz", "2.5");
    CHECK(program.pattern(0).amplitude_g == 1.5);
    CHECK(program.pattern(0).carriers[0].frequency_hz == 180.0);
    CHECK(program.pattern(0).modulation.frequency_hz == 2.5);
    CHECK(undo_label(program).empty());
}

TEST_CASE("numbers: what is looked at and left keeps the digits that are not shown") {
    PatternSet set = odd_numbers(1);
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 1.23456789;
    Program program(set);
    program.click("entry:amplitude_g");
    program.press_key(key::kEnter);
    enter(program, "entry:amplitude_g", "1.23 g");
    CHECK(program.pattern(0).amplitude_g == 1.23456789);
}

TEST_CASE("numbers: a click selects all of it, and typing replaces it") {
    Program program(odd_numbers(1));
    program.app.layout.left_split = 0.2F;  // times are visible as well
    program.settle();
    enter(program, "entry:amplitude_g", "2");
    CHECK(program.pattern(0).amplitude_g == 2.0);
    enter(program, "entry:amplitude_g", "0,8");
    CHECK(program.pattern(0).amplitude_g == 0.8);
    enter(program, "entry:amplitude_g", "1.3 g");
    CHECK(program.pattern(0).amplitude_g == 1.3);
    enter(program, "entry:amplitude_g", "*2");
    CHECK(program.pattern(0).amplitude_g == 2.6);
    enter(program, "entry:amplitude_g", "-50%");
    CHECK(program.pattern(0).amplitude_g == 1.3);
    enter(program, "entry:attack_ms", "0.02 s");
    CHECK(program.pattern(0).attack_s == doctest::Approx(0.02).epsilon(1e-12));
}

TEST_CASE("numbers: a sign is the number's own, and who may mean a sum is told so while typing") {
    Program program(odd_numbers(1));
    program.click("entry:amplitude_g");
    program.type("+0.5");
    CHECK(program.at("words on typed").value.starts_with("0.5 g itself; "));
    program.press_key(key::kEnter);
    CHECK(program.pattern(0).amplitude_g == 0.5);
    CHECK_FALSE(program.app.ui.status.is_error);
    program.click("entry:amplitude_g");
    for (const char* text : {"+10%", "0.5", "*2"}) {
        program.press('a', true);
        program.type(text);
        CHECK_FALSE(program.shows("words on typed"));
    }
}

TEST_CASE("numbers: Esc brings back what was") {
    Program program(odd_numbers(1));
    program.click("entry:carrier_1_hz");
    program.type("350");
    program.press_key(key::kEscape);
    CHECK(program.pattern(0).carriers[0].frequency_hz == 180.0);
    CHECK(undo_label(program).empty());
    CHECK_FALSE(program.app.ui.status.is_error);
}

TEST_CASE("numbers: Tab takes the number and goes to the next one, never into a slider") {
    Program program(odd_numbers(1));
    program.click("entry:amplitude_g");
    program.type("2");
    program.press_key(key::kTab);
    CHECK(program.pattern(0).amplitude_g == 2.0);
    program.type("222");
    program.press_key(key::kTab);
    CHECK(program.pattern(0).carriers[0].frequency_hz == 222.0);
    program.type("7");
    program.press_key(key::kEnter);
    CHECK(program.pattern(0).modulation.frequency_hz == 7.0);
}

TEST_CASE("numbers: Tab from a number that was only clicked goes on from number to number") {
    Program program(odd_numbers(1));
    program.click("entry:amplitude_g");
    // Between carrier and modulation are two links, and a text field before the attack.
    for (int k = 0; k < 3; ++k) program.press_key(key::kTab);
    program.type("12");
    program.press_key(key::kTab);
    program.press_key(key::kTab, false, true);
    program.press_key(key::kTab, false, true);
    program.type("9");
    program.press_key(key::kEnter);
    CHECK(program.pattern(0).attack_s == 0.012);
    CHECK(program.pattern(0).modulation.frequency_hz == 9.0);
    CHECK(program.pattern(0).rhythm.text.empty());
}

TEST_CASE("numbers: a double click on the label brings the default back, as one undo step") {
    Program program(odd_numbers(1));
    const Pattern normal;
    const auto reset = [&](const char* label) {
        for (int k = 0; k < 2; ++k) {
            window_click(program, label);
        }
        program.settle();
    };
    reset("field label:amplitude_g");
    CHECK(program.pattern(0).amplitude_g == normal.amplitude_g);
    CHECK(undo_label(program) == "Change amplitude of p1");
    reset("field label:carrier_1_hz");
    CHECK(program.pattern(0).carriers[0].frequency_hz == normal.carriers[0].frequency_hz);
    reset("field label:modulation_hz");
    CHECK(program.pattern(0).modulation.frequency_hz == normal.modulation.frequency_hz);
    program.press('z', true);
    CHECK(program.pattern(0).modulation.frequency_hz == 2.5);
    program.click("field label:amplitude_g");  // one click is not a double click
    CHECK(program.pattern(0).amplitude_g == normal.amplitude_g);
}

TEST_CASE("numbers: the label of a locked pattern resets nothing") {
    PatternSet set = odd_numbers(1);
    set.vibrations[0].locked = true;
    Program program(set);
    for (int k = 0; k < 2; ++k) window_click(program, "field label:amplitude_g");
    program.settle();
    CHECK(program.pattern(0).amplitude_g == 1.5);
}

TEST_CASE("numbers: a double click on the label of a dialog's number resets it, too") {
    Program program(odd_numbers(2));
    program.app.exports.picture_size.scale = 3.0F;
    program.app.layout.bench = BenchTab::subset;
    program.app.picking.count = 5;
    program.settle();
    for (int k = 0; k < 2; ++k) window_click(program, "subset label:count");
    program.settle();
    CHECK(program.app.picking.count == SubsetState{}.count);
}

TEST_CASE("numbers: a click elsewhere takes what was typed") {
    Program program(odd_numbers(2));
    program.click("entry:amplitude_g");
    program.type("2.25");
    program.click("row:p2");
    CHECK(program.pattern(0).amplitude_g == 2.25);
    CHECK(program.pattern(1).amplitude_g == 1.5);
    CHECK(undo_label(program) == "Change amplitude of p1");
}

TEST_CASE("numbers: what is no number is refused in sight, and what is out of range clamped so") {
    Program program(odd_numbers(1));
    enter(program, "entry:amplitude_g", "loud");
    CHECK(program.pattern(0).amplitude_g == 1.5);
    CHECK(program.app.ui.status.is_error);
    CHECK(says(program, "Amplitude: \"loud\" is no number"));
    CHECK(program.shows("status"));
    enter(program, "entry:amplitude_g", "99");
    CHECK(program.pattern(0).amplitude_g == limits::kAmplitudeG.high);
    CHECK(says(program, "Amplitude: 99 g is too much: 50 g"));
    enter(program, "entry:carrier_1_hz", "+3dB");
    CHECK(program.pattern(0).carriers[0].frequency_hz == 180.0);
    CHECK(says(program, "changes a strength"));
}

TEST_CASE("numbers: no entry of the panes takes what is not finite" * doctest::test_suite("long")) {
    PatternSet set = odd_numbers(3);
    auto& pattern = std::get<Pattern>(set.vibrations[0].source);
    pattern.carriers = {{100.0, 0.5}, {200.0, 0.25}, {300.0, 0.25}};
    pattern.rhythm.text = "x=--x=--";
    pattern.modulation.kind = ModulationKind::am;
    Program program(set);
    std::size_t tried = 0;
    const auto all = [&](const char* text) {
        tried += try_all(program, shown_entries(program), text);
    };
    program.app.layout.maximised = Pane::editor;
    program.settle();
    for (const char* text : kNoNumbers) all(text);
    CHECK(tried >= 4 * 11);
    tried = 0;
    program.app.layout.maximised = Pane::matrix;
    program.app.layout.bench = BenchTab::model;
    program.settle();
    all("nan");
    all("1e999");
    CHECK(tried >= 20);
    tried = 0;
    program.app.layout.bench = BenchTab::subset;
    program.settle();
    for (const char* text : kNoNumbers) tried += try_all(program, {"subset:count"}, text);
    CHECK(tried == 4);
    tried = 0;
    program.app.layout.maximised.reset();
    open_study(program.app.layout, program.app.studying);
    program.settle();
    all("nan");
    all("inf");
    CHECK(tried >= 4);
    program.app.studying.is_open = false;
}

TEST_CASE("numbers: no entry of a dialog takes what is not finite" * doctest::test_suite("long")) {
    Program program(odd_numbers(3));
    const auto refuses = [&](Dialog dialog, const std::vector<std::string>& entries,
                             std::size_t least) {
        program.app.ui.dialog = dialog;
        program.settle();
        for (const char* text : kNoNumbers) CHECK(try_all(program, entries, text) >= least);
        program.press_key(key::kEscape);
        program.app.ui.dialog = kNoDialog;
        program.settle();
    };
    refuses(kExportViewDialog, {"export:width", "export:height", "export:scale"}, 3);
    refuses(kExportAnimationDialog,
            {"export:from", "export:to", "export:frames", "export:width", "export:height"}, 5);
    refuses(kDevicesDialog, {"entry:full_scale_g"}, 0);
    program.press('g', true);
    program.click("generate:modulation range");
    program.click("generate:Sobol");
    program.click("generate:band");
    for (const char* text : kNoNumbers) {
        CHECK(try_all(program,
                      {"generate:modulation from", "generate:modulation to", "generate:samples",
                       "generate:seed", "generate:band low", "generate:band high"},
                      text) >= 5);
    }
}

TEST_CASE("numbers: Enter in an entry of a dialog takes the number and leaves the dialog open") {
    Program program(odd_numbers(2));
    program.app.ui.dialog = kExportViewDialog;
    program.settle();
    enter(program, "export:width", "1234");
    CHECK(program.app.exports.picture_size.width == 1234);
    CHECK(program.app.ui.dialog == kExportViewDialog);
    CHECK_FALSE(program.app.ui.chooser.is_open);
    program.click("export:width");
    program.type("99");
    program.press_key(key::kEscape);
    CHECK(program.app.exports.picture_size.width == 1234);
    CHECK(program.app.ui.dialog == kExportViewDialog);
}

TEST_CASE("numbers: digits typed at a field, locked or not, do not change the layout") {
    PatternSet set = odd_numbers(1);
    set.vibrations[0].locked = true;
    Program program(set);
    const float left = program.app.layout.left;
    const float right = program.app.layout.right;
    program.click("entry:amplitude_g");
    for (const char32_t digit : {U'1', U'2', U'3', U'5'}) program.press(digit);
    CHECK(program.app.layout.left == left);
    CHECK(program.app.layout.right == right);
    CHECK_FALSE(program.app.studying.is_open);
    // The same while the slider of an unlocked number is held.
    program.app.work.document.edit().vibrations[0].locked = false;
    program.settle();
    program.window.move(program.at("slider:amplitude_g").middle());
    program.window.button(true);
    program.settle();
    for (const char32_t digit : {U'1', U'2', U'3', U'5'}) program.press(digit);
    CHECK(program.app.layout.left == left);
    CHECK(program.app.layout.right == right);
    program.window.button(false);
    program.settle();
    program.click("row:p1");
    program.press(U'3', true);
    CHECK((program.app.layout.left != left || program.app.layout.right != right));
}

}  // namespace numbers_test
