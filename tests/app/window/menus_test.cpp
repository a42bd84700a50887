// What the menus say is so: the history goes to the step that was chosen, every key is listed.

#include "app/window/commands.h"
#include "app/window/dialogs.h"
#include "tests/support/program.h"

namespace menus_test {

using namespace tact;

TEST_CASE(
    "menus: a step of the history is gone back to, and forward again, whatever lies between") {
    Program program(short_patterns(3));
    const auto size = [&] { return program.app.work.document.set.vibrations.size(); };
    for (int k = 0; k < 3; ++k) program.click("button:duplicate");
    REQUIRE(size() == 6);
    const auto choose = [&](const std::string& step) {
        program.click("menu:Edit");
        program.click("menu:History");
        program.click(step);
    };
    choose("history:1");
    CHECK(size() == 4);
    choose("history:0");
    CHECK(size() == 3);
    choose("history:3");
    CHECK(size() == 6);
}

TEST_CASE("menus: the list of keys has that of every command") {
    std::string all;
    for (const KeyRow& row : keys_and_mouse()) all += row.keys + "\n";
    std::size_t count = 0;
    for (const Command& command : commands()) {
        const std::string keys = shortcut_text(command.shortcut);
        const bool by_number = std::string_view(command.name).starts_with("Play picked pattern");
        if (keys.empty() || by_number || command.shortcut.sign == '=') continue;
        CAPTURE(std::string(command.name));
        CHECK(all.find(keys) != std::string::npos);
        ++count;
    }
    CHECK(count > 30);
}

TEST_CASE("menus: every group that a menu has begins with a command that there is") {
    for (const std::string_view name : menu_groups()) {
        CAPTURE(std::string(name));
        CHECK(std::ranges::find(commands(), name, &Command::name) != commands().end());
    }
}

TEST_CASE("menus: a right click on a pane's title offers what can be done with it, and does it") {
    Program program(short_patterns(2));
    const auto open_on = [&](const std::string& pane) {
        program.window.move(program.at("title:" + pane).middle());
        program.settle();
        program.window.button(true, 1);
        program.settle();
        program.window.button(false, 1);
        program.settle();
    };
    for (const char* pane : {"Patterns", "Editor", "Perceptual space", "Matrix", "Physiology"}) {
        CAPTURE(pane);
        open_on(pane);
        CHECK(program.shows("pane menu:maximise"));
        program.press_key(key::kEscape);
    }
    open_on("Matrix");
    program.click("pane menu:maximise");
    CHECK(program.app.layout.maximised == Pane::matrix);
    open_on("Matrix");
    program.click("pane menu:maximise");
    CHECK_FALSE(program.app.layout.maximised);
    open_on("Patterns");
    program.click("menu:New pattern");
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

}  // namespace menus_test
