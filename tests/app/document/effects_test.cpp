// Effects of other programs in the window: opened, dropped, added, and never saved over.
#include <doctest/doctest.h>

#include <filesystem>

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/window/window.h"
#include "model/text/atomic_file.h"
#include "tests/support/program.h"
#include "tests/support/state_home.h"
#include "tests/support/temporary_folder.h"

namespace effects_test {

using namespace tact;

namespace {

const std::string kBuzz = R"({"timings": [100, 50], "amplitudes": [255, 128], "repeat": -1})";

}  // namespace

TEST_CASE(
    "effects: dropped on the window they are a set, and the status line says what was assumed") {
    const TemporaryFolder folder;
    folder.write("buzz.json", kBuzz);
    Program program(short_patterns(2));
    drop_paths(program.app, {folder.path / "buzz.json"});
    const PatternSet& set = program.app.work.document.set;
    REQUIRE(set.vibrations.size() == 1);
    CHECK(set.vibrations[0].name == "buzz");
    CHECK(program.app.ui.status.text.find("165 Hz are guessed") != std::string::npos);
    CHECK(program.app.ui.status.text.find("actuator map android") != std::string::npos);
}

TEST_CASE("effects: saving a set made of a .json of Android asks for a name of its own") {
    const TemporaryFolder folder;
    folder.write("buzz.json", kBuzz);
    Program program(short_patterns(2));
    open_paths(program.app.ui, program.app.work, program.app.opening, {folder.path / "buzz.json"});
    program.app.work.document.edit().vibrations[0].name = "changed";
    document_changed(program.app.work);
    save(program.app.ui, program.app.work);
    CHECK(program.app.ui.chooser.is_open);
    CHECK(*read_text_file(folder.path / "buzz.json") == kBuzz);
}

TEST_CASE("effects: added to a set they come behind the current pattern, as one step") {
    const TemporaryFolder folder;
    folder.write("buzz.json", kBuzz);
    folder.write("bad.ahap", "{");
    Program program(short_patterns(3));
    Workspace& work = program.app.work;
    const PatternSet before = work.document.set;
    select_only(work, 1);
    add_paths(program.app.ui, work, program.app.opening, {folder.path / "bad.ahap"});
    CHECK(work.document.set == before);
    CHECK(program.app.ui.status.is_error);
    add_paths(program.app.ui, work, program.app.opening,
              {folder.path / "buzz.json", folder.path / "buzz.json"});
    REQUIRE(work.document.set.vibrations.size() == 5);
    CHECK(work.document.set.vibrations[2].name == "buzz");
    CHECK(work.document.set.vibrations[3].name == "buzz.json");
    CHECK(selected_indices(work) == std::vector<std::size_t>{2, 3});
    undo(program.app.ui, work);
    CHECK(work.document.set == before);
}

}  // namespace effects_test
