// The tab of the library: a folder is opened, searched, and taken from.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/document/editing.h"
#include "app/library/library.h"
#include "app/window/window.h"
#include "model/io/set/set_file.h"
#include "tests/support/felt_program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace library_panel_test {

using namespace tact;

namespace {

Pattern tone(double hz, double duration_s) {
    Pattern pattern;
    pattern.amplitude_g = 0.6;
    pattern.carriers[0].frequency_hz = hz;
    pattern.duration_s = duration_s;
    return pattern;
}

Vibration called(const char* name, const Pattern& pattern) {
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

void open_tones(Program& program, const TemporaryFolder& folder) {
    PatternSet set;
    Pattern rises = tone(120.0, 0.2);
    rises.amplitude_curve = {{0.0, 0.0}, {0.2, 1.0}};
    set.vibrations = {called("low", tone(60.0, 0.1)), called("high", tone(250.0, 0.1)),
                      called("rises", rises)};
    set.vibrations[1].note = "A sharp one. Tags: urgent, bright.";
    REQUIRE(write_set_file(folder.path / "tones.tactspace.json", set));
    program.app.layout.bench = BenchTab::library;
    program.settle();
    show_library(program.app.ui, program.app.library, folder.path);
    wait_until(program, [&] { return program.app.library.library != nullptr; });
    program.settle();
}

struct Shelf {
    TemporaryFolder folder;
    Program program{short_patterns(2)};

    Shelf() { open_tones(program, folder); }

    App& app() { return program.app; }
    std::size_t count() { return app().work.document.set.vibrations.size(); }
    std::vector<std::string> listed() {
        std::vector<std::string> names;
        for (const LibraryRow& row : library_rows(app().library))
            names.push_back(app().library.library->entries[row.entry].name);
        return names;
    }
};

}  // namespace

TEST_CASE("library: without one the tab says what it is for") {
    Program program(short_patterns(2));
    program.app.layout.bench = BenchTab::library;
    program.settle();
    CHECK(program.shows("library:open"));
    CHECK_FALSE(program.shows("library:words"));
}

TEST_CASE("library: words narrow the list, and headings sort it") {
    Shelf shelf;
    CHECK(shelf.listed() == std::vector<std::string>{"low", "high", "rises"});
    shelf.app().library.words = "URGENT";
    CHECK(shelf.listed() == std::vector<std::string>{"high"});
    shelf.app().library.words.clear();
    shelf.program.click("library:by frequency");
    CHECK(shelf.listed() == std::vector<std::string>{"low", "rises", "high"});
    shelf.program.click("library:by frequency");
    CHECK(shelf.listed() == std::vector<std::string>{"high", "rises", "low"});
}

TEST_CASE("library: what is chosen is added as one step, and undo takes it back") {
    Shelf shelf;
    shelf.program.click("library row:low");
    shelf.program.click("library:add");
    wait_until(shelf.program, [&] { return shelf.count() == 3; });
    CHECK(current_vibration(shelf.app().work)->name == "low");
    undo(shelf.app().ui, shelf.app().work);
    CHECK(shelf.count() == 2);
}

TEST_CASE("library: a row that is dragged out of the pane is added, one that comes back is not") {
    Shelf shelf;
    Program& program = shelf.program;
    const ImVec2 row = program.at("library row:high").middle();
    program.drag(row, program.at("library row:low").middle(), 4);
    CHECK(shelf.count() == 2);
    program.drag(row, program.at("search").middle(), 6);
    wait_until(program, [&] { return shelf.count() == 3; });
    CHECK(current_vibration(shelf.app().work)->name == "high");
}

TEST_CASE("library: the nearest to the current pattern comes first, and Clear takes it back") {
    Shelf shelf;
    Program& program = shelf.program;
    edit_current_pattern(shelf.app().work, tone(250.0, 0.1));
    program.settle();
    program.click("library:like");
    wait_until(program, [&] { return shelf.app().library.alike != nullptr; });
    program.settle();
    CHECK(shelf.listed().front() == "high");
    CHECK(program.at("library:order").value.find("like p1") == 0);

    edit_current_pattern(shelf.app().work, tone(240.0, 0.1));
    program.settle();
    CHECK(program.at("library:order").value.find("before it was changed") != std::string::npos);
    edit_current_pattern(shelf.app().work, tone(250.0, 0.1));
    program.settle();
    CHECK(program.at("library:order").value.find("before it was changed") == std::string::npos);

    program.click("library:target");
    program.click("library target:android-xml");
    wait_until(program, [&] { return shelf.app().library.alike->request.target == "android-xml"; });
    program.settle();
    CHECK(program.at("library:order").value.find("itself there: PM") != std::string::npos);
    program.click("library:clear");
    CHECK_FALSE(shelf.app().library.alike);
    CHECK(shelf.listed().front() == "low");
}

TEST_CASE("library: a shape that is drawn puts what has it first") {
    Shelf shelf;
    Program& program = shelf.program;
    const Place box = program.at("library:shape");
    program.drag({box.min.x + 2.0F, box.max.y - 1.0F}, {box.max.x - 2.0F, box.min.y + 1.0F}, 12);
    CHECK(program.at("library:shape").value == "drawn");
    CHECK(shelf.listed().front() == "rises");
    program.click("library:clear");
    CHECK(shelf.listed().front() == "low");
}

TEST_CASE("library: more like a chosen one is asked of the library itself") {
    Shelf shelf;
    Program& program = shelf.program;
    program.click("library row:rises");
    program.click("library:more like it");
    wait_until(program, [&] { return shelf.app().library.alike != nullptr; });
    CHECK(shelf.listed().front() == "rises");
}

TEST_CASE("library: what cannot be compared is said, and the list stays") {
    Shelf shelf;
    Program& program = shelf.program;
    program.click("library row:rises");
    std::filesystem::remove(shelf.folder.path / "tones.tactspace.json");
    program.click("library:more like it");
    wait_until(program, [&] { return shelf.app().ui.status.is_error; });
    CHECK_FALSE(shelf.app().library.alike);
    CHECK(shelf.listed().size() == 3);
}

TEST_CASE("library: a held row is felt as long as it is held") {
    const TemporaryFolder folder;
    FeltProgram program;
    open_tones(program, folder);
    program.window.move(program.at("library row:high").middle());
    program.window.button(true);
    program.settle();
    wait_until(program, [&] {
        const auto& holder = program.app.library.holder;
        return holder.latest() != nullptr;
    });
    program.wait(kHoldS + 0.05);
    CHECK(program.device->playing());
    CHECK(program.app.play.sounding->as_played.name == "high");
    program.window.button(false);
    program.settle();
    CHECK_FALSE(program.device->playing());
    CHECK_FALSE(program.app.library.held);
}

TEST_CASE("library: a folder that cannot be read is said, and another document keeps the library") {
    Shelf shelf;
    Program& program = shelf.program;
    program.click("library:like");
    wait_until(program, [&] { return shelf.app().library.alike != nullptr; });
    new_document(shelf.app().ui, shelf.app().work);
    program.settle();
    CHECK_FALSE(shelf.app().library.alike);
    CHECK(shelf.listed().size() == 3);
    show_library(shelf.app().ui, shelf.app().library, shelf.folder.path / "not there");
    wait_until(program, [&] { return shelf.app().library.library->entries.empty(); });
    CHECK(shelf.app().ui.status.is_error);
}

}  // namespace library_panel_test
