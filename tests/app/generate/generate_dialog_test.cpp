// The dialog for candidates, and rhythms by the list.
#include <doctest/doctest.h>

#include "app/document/editing.h"
#include "app/generate/generate.h"
#include "model/io/set/set_file.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace generate_dialog_test {

using namespace tact;

namespace {

// Frames until the plan on screen is that of the draft.
std::shared_ptr<const GeneratePlan> wait_for_plan(Program& program) {
    const auto until = end_of_patience();
    program.settle();
    while (!current_plan(program.app.work, program.app.generating)) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.frame();
    }
    program.settle();
    return current_plan(program.app.work, program.app.generating);
}

void type_into(Program& program, const std::string& entry, const std::string& text) {
    program.click(entry);
    push(program.window.input,
         {program.window.now_s, KeyChange{key::kLeftControl, true, false, 0}});
    program.window.press('A', 'a');
    push(program.window.input,
         {program.window.now_s, KeyChange{key::kLeftControl, false, false, 0}});
    program.window.type(text);
    program.settle();
}

// Six candidates: three frequencies, two modulations.
void open_dialog(Program& program) {
    program.press('g', true);
    REQUIRE(program.shows("generate:count"));
    wait_for_plan(program);
}

std::size_t size_of(const Program& program) {
    return program.app.work.document.set.vibrations.size();
}

}  // namespace

TEST_CASE("generate dialog: it opens on the current pattern varied, counted before it runs") {
    Program program(short_patterns(3));
    open_dialog(program);
    CHECK(program.at("generate:count").value == "5 patterns");
    CHECK(program.at("generate:losses").value ==
          "6 combinations, 1 in the set already");  // 60 Hz without modulation
    CHECK(program.shows("generate:preview 4"));
    CHECK_FALSE(program.shows("generate:preview 5"));
    CHECK(program.app.work.document.set == short_patterns(3));
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("generate dialog: what was drawn by hand is said to be left out") {
    Program program(short_patterns(1));
    open_dialog(program);
    CHECK(!program.shows("generate:left out"));
    program.press_key(key::kEscape);
    auto& pattern = std::get<Pattern>(program.app.work.document.edit().vibrations[0].source);
    pattern.transients = {{0.05, 1.0}};
    program.settle();
    open_dialog(program);
    CHECK(program.at("generate:left out").value.find("p1") != std::string::npos);
}

TEST_CASE("generate dialog: adding is one step with its generator; undo and redo take it whole") {
    Program program(short_patterns(3));
    open_dialog(program);
    program.click("button:add candidates");
    CHECK_FALSE(program.shows("generate:count"));
    CHECK(size_of(program) == 8);
    CHECK(program.app.work.selection.current == 3);
    const PatternSet after = program.app.work.document.set;
    REQUIRE(after.generator);
    CHECK(after.vibrations[3].generated);
    program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(3));
    program.press('z', true, true);
    CHECK(program.app.work.document.set == after);
}

TEST_CASE("generate dialog: it opens again on the same generator, and replaces what it made") {
    Program program(short_patterns(1));
    open_dialog(program);
    program.click("button:add candidates");
    const std::size_t added = size_of(program) - 1;
    open_dialog(program);
    CHECK(program.app.generating.draft == program.app.work.document.set.generator);
    CHECK(program.at("generate:count").value == "0 patterns");
    type_into(program, "generate:modulation", "4, 16");
    const auto plan = wait_for_plan(program);
    CHECK(plan->generated_before == added);
    CHECK(plan->replace.fresh.size() == 6);
    program.click("button:replace generated");
    CHECK(size_of(program) == 7);
    CHECK(program.app.work.document.set.vibrations[0].name == "p1");
    CHECK(program.app.work.document.set.generator->modulation_hz ==
          Values(std::vector<double>{4.0, 16.0}));
}

TEST_CASE("generate dialog: a generated pattern that is edited, renamed or locked stays") {
    Program program(short_patterns(1));
    open_dialog(program);
    program.click("button:add candidates");
    const std::size_t size = size_of(program);
    select_only(program.app.work, 1);
    edit_patterns(program.app.work, [](Pattern& p) { p.amplitude_g = 3.0; });
    commit_step(program.app.ui, program.app.work, "Change amplitude");
    rename_vibration(program.app.ui, program.app.work, 2, "mine");
    select_only(program.app.work, 3);
    toggle_locked(program.app.ui, program.app.work);
    open_dialog(program);
    const auto plan = wait_for_plan(program);
    CHECK(plan->generated_before == size - 4);
}

TEST_CASE("generate dialog: what is typed wrong is said and changes nothing") {
    Program program(short_patterns(1));
    open_dialog(program);
    const DesignSpace before = program.app.generating.draft;
    type_into(program, "generate:amplitude", "1, 99");
    CHECK(program.at("generate:fault").value == "0 to 50 g");
    CHECK(program.app.generating.draft == before);
    type_into(program, "generate:amplitude", "loud");
    CHECK(program.at("generate:fault").value == "\"loud\" is no number");
    program.window.press(key::kEscape);
    program.settle();
    CHECK(program.shows("generate:count"));  // Esc left the entry only
    CHECK(program.at("generate:amplitude").value == "1");
    program.window.press(key::kEscape);
    program.settle();
    CHECK_FALSE(program.shows("generate:count"));
    CHECK(size_of(program) == 1);
}

TEST_CASE("generate dialog: no entry is dropped, nor read as another number, without a sentence") {
    Program program(short_patterns(1));
    open_dialog(program);
    struct Typed {
        const char* text;
        std::vector<double> taken;  // empty: refused
        const char* said;
    };
    const std::vector<Typed> all{
        {"0.5, 1, 0.5, abc", {}, "\"abc\" is no number"},
        {"0.0001,60", {}, "0 to 50 g"},
        {"0,5; 1", {}, "\"0,5\" is one number or two: write 0.5, or a blank after the comma"},
        {"1,5; 2", {}, "\"1,5\" is one number or two: write 1.5, or a blank after the comma"},
        {"0,5", {}, "\"0,5\" is one number or two: write 0.5, or a blank after the comma"},
        {"0.5, 1, 0.5", {0.5, 1.0, 0.5}, "3 levels, 0.5 of them 2 times"},
        {"0.5,1", {0.5, 1.0}, "2 levels"},
        {"0, 5", {0.0, 5.0}, "2 levels"},
        {"1,5", {1.0, 5.0}, "2 levels"},
        {"0.5; 1", {0.5, 1.0}, "2 levels"},
        {"2", {2.0}, "fixed"}};
    for (const Typed& one : all) {
        CAPTURE(one.text);
        const DesignSpace before = program.app.generating.draft;
        type_into(program, "generate:amplitude", one.text);
        program.click("generate:count");  // and left: what was refused is still said to be
        if (one.taken.empty()) {
            CHECK(program.app.generating.draft == before);
            CHECK(program.at("generate:fault").value == "Not taken: " + std::string(one.said));
        } else {
            CHECK(std::get<std::vector<double>>(program.app.generating.draft.amplitude_g) ==
                  one.taken);
            CHECK_FALSE(program.shows("generate:fault"));
            CHECK(program.at("generate:remark amplitude").value == one.said);
        }
    }
}

TEST_CASE("generate dialog: levels, ranges and designs are counted as they change") {
    Program program(short_patterns(1));
    open_dialog(program);
    type_into(program, "generate:amplitude", "0.5, 1, 2");
    CHECK(wait_for_plan(program)->found.combinations == 18);
    program.click("generate:modulation range");
    type_into(program, "generate:modulation steps", "5");
    CHECK(wait_for_plan(program)->found.combinations == 45);
    program.click("generate:Sobol");
    type_into(program, "generate:samples", "120");
    CHECK(wait_for_plan(program)->found.combinations == 120);
    program.click("generate:band");
    const auto plan = wait_for_plan(program);
    CHECK(plan->request.space.constraints.band_hz == Range{40.0, 400.0});
    CHECK(plan->found.kept.size() + plan->found.doubles + plan->found.rejected.band == 120);
}

TEST_CASE("generate dialog: a design that is too large says so and adds nothing") {
    Program program(short_patterns(1));
    program.app.generating.begun = true;
    program.app.generating.draft.amplitude_g = Span{0.0, 1.0, 1000, false, 0.0};
    program.app.generating.draft.depth = Span{0.0, 1.0, 1000, false, 0.0};
    open_dialog(program);
    CHECK(program.at("generate:count").value == "No patterns");
    CHECK(contains(program.at("generate:design fault").value, "1,000,000 combinations"));
    program.click("button:add candidates");
    CHECK(size_of(program) == 1);
}

TEST_CASE("generate dialog: more than two hundred patterns are asked about first") {
    Program program(short_patterns(1));
    program.app.generating.begun = true;
    program.app.generating.draft.amplitude_g = Span{0.1, 1.0, 250, false, 0.0};
    program.app.generating.draft.duration_s = fixed(0.1);
    open_dialog(program);
    program.click("button:add candidates");
    CHECK(program.shows("generate:question"));
    CHECK(size_of(program) == 1);
    program.click("button:back");
    CHECK_FALSE(program.shows("generate:question"));
    program.click("button:add candidates");
    program.click("button:generate all the same");
    CHECK(size_of(program) == 251);
}

TEST_CASE("generate dialog: candidates and their generator survive saving and opening") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    open_dialog(program);
    program.click("generate:Sobol");
    wait_for_plan(program);
    program.click("button:add candidates");
    const std::filesystem::path path = folder.path / "made.tactspace.json";
    save_as(program.app.ui, program.app.work, path);
    const auto read = read_set_file(path);
    REQUIRE(read);
    CHECK(read->set == program.app.work.document.set);
}

TEST_CASE("generate dialog: two carriers are mixed, and rhythms come from the list") {
    Program program(short_patterns(1));
    open_dialog(program);
    program.click("generate:add carrier");
    CHECK(program.shows("generate:mix"));
    CHECK_FALSE(program.shows("generate:weight 1"));
    program.click("generate:choose rhythms");
    CHECK(program.at("rhythm list:count").value == "7");
    program.click("link:all rhythms");
    CHECK(program.app.generating.draft.rhythms.size() == 8);
    program.click("rhythm:x--x--x-");
    CHECK(program.app.generating.draft.rhythms.size() == 7);
}

TEST_CASE("rhythm list: a rhythm is previewed under the mouse and taken by a click, one step") {
    Program program(short_patterns(1));
    program.click("link:rhythms");
    REQUIRE(program.shows("rhythm list:count"));
    CHECK(program.at("rhythm list:count").value == "7");
    program.hover(program.at("rhythm:x--x--x-").middle());
    CHECK(program.at("rhythm envelope").value == "x--x--x-");
    CHECK(program.pattern(0).rhythm.text.empty());
    program.click("rhythm:x--x--x-");
    CHECK(program.pattern(0).rhythm.text == "x--x--x-");
    program.click("rhythm list:2 steps");
    program.click("rhythm:x=-x=-x=");
    CHECK(program.pattern(0).rhythm.text == "x=-x=-x=");
    program.click("rhythm list:Euclidean");
    CHECK(program.at("rhythm list:count").value == "8");
    program.window.press(key::kEscape);
    program.settle();
    program.press('z', true);
    program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(1));
}

TEST_CASE("rhythm grid: dragging to the right draws a note as long as the drag, one step") {
    Program program(short_patterns(1));
    program.click("link:make a rhythm");
    CHECK(program.pattern(0).rhythm.text == "x=--x=--");
    CHECK(contains(program.at("rhythm summary").value, "2 notes on 8 steps, evenness 1.00"));
    program.drag(program.at("step:2").middle(), program.at("step:5").middle(), 4);
    CHECK(program.pattern(0).rhythm.text == "x=x===--");
    program.drag(program.at("step:2").middle(), program.at("step:3").middle(), 2);
    CHECK(program.pattern(0).rhythm.text == "x=x=----");
    program.press('z', true);
    CHECK(program.pattern(0).rhythm.text == "x=x===--");
    program.press('z', true);
    CHECK(program.pattern(0).rhythm.text == "x=--x=--");
}

}  // namespace generate_dialog_test
