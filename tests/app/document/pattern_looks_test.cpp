// Colour and mark belong to the pattern: from its birth, through all that is done to the list.
#include "app/document/workspace.h"

#include <doctest/doctest.h>

#include <map>

#include "app/document/editing.h"
#include "app/opening/opening.h"
#include "app/pictures/pictures.h"
#include "model/io/set/set_file.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace pattern_looks_test {

using namespace tact;

namespace {

using Look = std::pair<std::string, bool>;

std::map<std::string, Look> looks_of(const PatternSet& set) {
    std::map<std::string, Look> looks;
    for (const Vibration& vibration : set.vibrations) {
        looks[vibration.name] = {vibration.colour, vibration.ring};
    }
    return looks;
}

std::map<std::string, Look> looks_of(const Program& program) {
    return looks_of(program.app.work.document.set);
}

// Those of `before` are as they were; how many others there are.
std::size_t kept_and_new(const std::map<std::string, Look>& before,
                         const std::map<std::string, Look>& now) {
    std::size_t kept = 0;
    for (const auto& [name, look] : before) {
        if (now.contains(name)) CHECK(now.at(name) == look);
        kept += now.contains(name) ? 1 : 0;
    }
    return now.size() - kept;
}

PatternSet bare_patterns(std::size_t count) {
    PatternSet set = short_patterns(count);
    for (Vibration& vibration : set.vibrations) {
        vibration.colour.clear();
        vibration.ring = false;
    }
    return set;
}

void open_menu(Program& program, const std::string& row) {
    program.window.move(program.at("row name:" + row).middle());
    program.window.button(true, 1);
    program.window.button(false, 1);
    program.settle();
}

}  // namespace

TEST_CASE("looks: sixteen patterns all look different, and of more each look is as often used") {
    PatternSet set = bare_patterns(48);
    give_looks(set);
    std::map<Look, int> used;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        const Vibration& vibration = set.vibrations[k];
        ++used[{vibration.colour, vibration.ring}];
        CHECK(look_of(dark_theme(1.0F), set, k) == pattern_look(dark_theme(1.0F), k));
    }
    CHECK(used.size() == 16);
    for (const auto& [look, count] : used) CHECK(count == 3);
}

TEST_CASE("looks: a new pattern takes the least used one, whoever has one keeps it") {
    PatternSet set = bare_patterns(4);
    set.vibrations[1].colour = "#56b4e9";  // the first of the palette
    set.vibrations[2].colour = "#123456";  // of nobody's palette
    give_looks(set);
    CHECK(set.vibrations[1].colour == "#56b4e9");
    CHECK(set.vibrations[2].colour == "#123456");
    CHECK(set.vibrations[0].colour == kPatternColours[1].hex);
    CHECK(set.vibrations[3].colour == kPatternColours[2].hex);
    const PatternSet before = set;
    give_looks(set);
    CHECK(set == before);
}

TEST_CASE("looks: moving, New, Duplicate, paste, delete and undo leave every pattern its own") {
    Program program(short_patterns(4));
    App& app = program.app;
    const auto before = looks_of(program);
    move_vibration(app.ui, app.work, 3, 0);
    CHECK(looks_of(program) == before);
    add_pattern(app.ui, app.work);
    CHECK(kept_and_new(before, looks_of(program)) == 1);
    const auto with_new = looks_of(program);
    duplicate_selected(app.ui, app.work);
    CHECK(kept_and_new(with_new, looks_of(program)) == 1);
    copy_selected(app.ui, app.work);
    paste(app.ui, app.work);
    std::set<Look> different;
    for (const auto& [name, look] : looks_of(program)) different.insert(look);
    CHECK(different.size() == 7);  // also the copies
    select_only(app.work, *place_named(app.work.document.set, "p2"));
    remove_selected(app.ui, app.work);
    CHECK(kept_and_new(before, looks_of(program)) == 3);
    rename_vibration(app.ui, app.work, 0, "another name");
    CHECK(looks_of(program).at("another name") == before.at("p4"));
    while (app.work.document.history.undo_label() != nullptr) {
        undo(app.ui, app.work);
        kept_and_new(before, looks_of(program));
    }
    CHECK(looks_of(program) == before);
    CHECK(app.work.document.set == app.work.document.saved);
}

TEST_CASE("looks: a set without colours gets its own when it is opened, and is not changed by it") {
    const TemporaryFolder folder;
    const auto file = folder.path / "bare.tactspace.json";
    REQUIRE(write_set_file(file, bare_patterns(3)));
    Program program({});
    App& app = program.app;
    open_paths(app.ui, app.work, app.opening, {file});
    program.settle();
    const auto first = looks_of(program);
    REQUIRE(first.size() == 3);
    for (const auto& [name, look] : first) CHECK_FALSE(look.first.empty());
    CHECK_FALSE(app.work.unsaved);
    // Nor are they others the next time, though nothing was saved.
    open_paths(app.ui, app.work, app.opening, {file});
    CHECK(looks_of(program) == first);
    // Saved in another order, they are those of the patterns.
    move_vibration(app.ui, app.work, 0, 2);
    save(app.ui, app.work);
    open_paths(app.ui, app.work, app.opening, {file});
    CHECK(app.work.document.set.vibrations[2].name == "p1");
    CHECK(looks_of(program) == first);
}

TEST_CASE("looks: the row's menu changes colour and mark of what is selected, in one step each") {
    Program program(short_patterns(3));
    const auto before = looks_of(program);
    open_menu(program, "p2");
    program.click("row menu:Colour and mark");
    program.click("row menu:Purple");
    CHECK(looks_of(program).at("p2") == Look{"#CC79A7", false});
    CHECK(*program.app.work.document.history.undo_label() == "Change colour of p2");
    open_menu(program, "p2");
    program.click("row menu:Colour and mark");
    CHECK(program.at("row menu:Purple").value == "chosen");
    program.click("row menu:Ring");
    CHECK(looks_of(program).at("p2") == Look{"#CC79A7", true});
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    CHECK(looks_of(program) == before);
    // A locked pattern keeps its vibration; how it looks is no part of that.
    program.app.work.document.edit().vibrations[0].locked = true;
    select_only(program.app.work, 0);
    program.app.work.selection.others = {2};
    change_look(program.app.ui, program.app.work, "#D55E00", false);
    CHECK(looks_of(program).at("p1").first == "#D55E00");
    CHECK(looks_of(program).at("p3").first == "#D55E00");
    CHECK(looks_of(program).at("p2") == before.at("p2"));
}

}  // namespace pattern_looks_test
