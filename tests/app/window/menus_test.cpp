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

TEST_CASE("menus: the list of keys needs no scroll bar in a small window, and is searched") {
    Program program(short_patterns(2));
    program.resize({1280.0F, 720.0F}, 1.0F);
    program.press_key(key::kF1);
    program.settle();
    for (const KeyRow& row : keys_and_mouse()) {
        CAPTURE(row.group);
        CHECK(program.at("keys:" + row.group).max.y < program.at("button:close").min.y);
    }
    CHECK(program.app.manual.keys_height_px <=
          program.at("button:close").min.y - program.at("keys:File").min.y);
    program.type("lasso");
    CHECK(program.shows("keys:Map"));
    CHECK_FALSE(program.shows("keys:File"));
    program.press_key(key::kEnter);  // is the search's own
    CHECK(program.app.ui.dialog == Dialog::keys);
    program.press_key(key::kEscape);
    CHECK(program.app.ui.dialog == Dialog::none);
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
