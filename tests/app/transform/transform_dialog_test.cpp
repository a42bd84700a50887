// Edits of the selected patterns, in the window: the model's answer, as one step of undo.
#include "app/transform/transform.h"
#include "model/algebra/set_edits.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace transform_dialog_test {

using namespace tact;

namespace {

std::shared_ptr<const Transformed> wait_for_patterns(Program& program) {
    const auto until = end_of_patience();
    program.settle();
    while (!current_transform(program.app.work, program.app.transform)) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
    return current_transform(program.app.work, program.app.transform);
}

void open(Program& program, EditKind kind) {
    open_transform(program.app.ui, program.app.work, program.app.transform);
    program.app.transform.kind = kind;
}

}  // namespace

TEST_CASE("transform: what is applied is what the terminal makes, and one step of undo") {
    Program program(short_patterns(3));
    const PatternSet before = program.app.work.document.set;
    for (const EditKind kind : {EditKind::stretch, EditKind::reverse, EditKind::repeat,
                                EditKind::join, EditKind::fade_out, EditKind::normalise}) {
        CAPTURE(traits(kind).key);
        // Their modulations differ: a join is of one pattern with itself.
        const bool alone = kind == EditKind::join;
        alone ? select_only(program.app.work, 0) : select_all(program.app.work);
        open(program, kind);
        if (alone) program.app.transform.other = "p1";
        program.app.transform.numbers[static_cast<std::size_t>(EditKind::fade_out)] = 0.01;
        wait_for_patterns(program);
        program.click("button:choose");
        const double number = kind == EditKind::fade_out ? 0.01 : traits(kind).start;
        const std::vector<NamedEdit> edits{{kind, number, program.app.transform.other}};
        const auto names = alone ? std::vector<std::string>{"p1"} : names_of(before);
        const auto expected = with_edits(before, names, edits);
        INFO((expected ? "" : expected.error().message));
        REQUIRE(expected);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(program.app.work.document.set.vibrations[k].source ==
                  expected->vibrations[k].source);
        }
        CHECK(program.app.ui.dialog == kNoDialog);
        undo(program.app.ui, program.app.work);
        CHECK(program.app.work.document.set == before);
    }
}

TEST_CASE("transform: what cannot be done is said, and Apply waits for something that can") {
    Program program(short_patterns(2));
    select_only(program.app.work, 0);
    toggle_locked(program.app.ui, program.app.work);
    const PatternSet before = program.app.work.document.set;
    open(program, EditKind::reverse);
    program.settle();
    CHECK(program.at("transform:obstacle").value == "Select a pattern that is not locked.");
    program.click("button:cancel");
    select_all(program.app.work);
    open(program, EditKind::transpose);
    program.app.transform.numbers[static_cast<std::size_t>(EditKind::transpose)] = 100.0;
    wait_for_patterns(program);
    CHECK(program.at("transform:outcome").value.find("transpose: expected a carrier from 0.1 to") !=
          std::string::npos);
    CHECK(program.at("transform:changes").value == "p2; 1 is locked and stays as it is");
    program.click("button:choose");
    CHECK(program.app.work.document.set == before);
    CHECK(program.app.ui.dialog == kTransformDialog);
    // The other kind is chosen by hand: the answer follows.
    program.click("transform:kind");
    program.click("transform:kind:repeat");
    wait_for_patterns(program);
    CHECK(program.at("transform:number").value == "2");
    program.click("button:choose");
    CHECK(program.app.work.document.set.vibrations[0] == before.vibrations[0]);
    CHECK(!(program.app.work.document.set.vibrations[1] == before.vibrations[1]));
}

TEST_CASE("transform: of several, those that can are changed, and the first that cannot is named") {
    Program program(short_patterns(2));
    select_only(program.app.work, 0);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.0; });
    commit_step(program.app.ui, program.app.work, "silence");
    const PatternSet before = program.app.work.document.set;
    select_all(program.app.work);
    open(program, EditKind::normalise);
    program.app.transform.numbers[static_cast<std::size_t>(EditKind::normalise)] = 0.5;
    wait_for_patterns(program);
    CHECK(program.at("transform:outcome").value ==
          "1 pattern is ready, 1 cannot change: \"p1\", normalise: expected a pattern that is not "
          "silent.");
    program.click("button:choose");
    CHECK(program.app.work.document.set.vibrations[0] == before.vibrations[0]);
    CHECK(!(program.app.work.document.set.vibrations[1] == before.vibrations[1]));
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("transform: a change of the document asks again, and no old answer is applied") {
    Program program(short_patterns(2));
    open(program, EditKind::stretch);
    wait_for_patterns(program);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.123; });
    CHECK(!current_transform(program.app.work, program.app.transform));
    const VibrationSource after = wait_for_patterns(program)->after.front();
    CHECK(std::get<Pattern>(after).amplitude_g == 0.123);
}

}  // namespace transform_dialog_test
