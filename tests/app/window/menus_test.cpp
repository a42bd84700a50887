// Menus tell the truth: the history goes to the chosen step, every key is listed.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>

#include "app/window/window.h"
#include "model/text/atomic_file.h"
#include "tests/support/program.h"

namespace menus_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// "File > Open..." as a sentence has it: "File > Open".
std::string without_dots(std::string path) {
    if (path.ends_with("...")) path.resize(path.size() - 3);
    return path;
}

// Every item, and every submenu.
std::set<std::string> menu_places() {
    // These are lists that are made while the program runs.
    std::set<std::string> places{"File > Open recent", "File > Example sets", "Edit > History",
                                 "View > My workspaces", "Lesson > Language"};
    for (const Command& command : commands()) {
        if (command.menu[0] == '\0') continue;
        const std::string path = menu_path(command);
        places.insert(without_dots(path));
        const std::size_t last = path.rfind(" > ");
        if (path.find(" > ") != last) places.insert(path.substr(0, last));
    }
    return places;
}

// If a text names a menu item that does not exist: the text from there on.
std::vector<std::string> wrong_places(const std::string& text) {
    static const std::set<std::string> places = menu_places();
    static const std::regex named("\\b(File|Edit|View|Play|Study|Lesson|Help) > ");
    std::vector<std::string> wrong;
    for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at) {
        const std::string rest = text.substr(static_cast<std::size_t>(at->position()), 100);
        const bool is_there = std::ranges::any_of(places, [&](const std::string& place) {
            const bool goes_on_as_word =
                rest.size() > place.size() &&
                std::isalnum(static_cast<unsigned char>(rest[place.size()])) != 0;
            return rest.starts_with(place) && !goes_on_as_word;
        });
        if (!is_there) wrong.push_back(rest);
    }
    return wrong;
}

// On one line, as a reader sees it: a page, or consecutive literals of a source file.
std::string as_read(const std::string& bytes) {
    static const std::regex joint("\"\\s*\\+?\\s*\"");
    static const std::regex space("\\s+");
    static const std::regex sign("&gt;");
    return std::regex_replace(std::regex_replace(std::regex_replace(bytes, sign, ">"), joint, ""),
                              space, " ");
}

}  // namespace

TEST_CASE("menus: whatever the manual, the README or the program itself names there is there") {
    REQUIRE(wrong_places("File > Nothing such").size() == 1);
    REQUIRE(wrong_places("File > Opening").size() == 1);
    REQUIRE(wrong_places("Stages > Stages in one row, File > Open... and View > Map.").empty());
    const fs::path root = fs::path(__FILE__).parent_path() / "../../..";
    std::vector<fs::path> files{root / "README.md"};
    for (const char* folder : {"assets/manual", "app"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".html" || ending == ".cpp") files.push_back(entry.path());
        }
    }
    REQUIRE(files.size() > 200);
    for (const fs::path& file : files) {
        const auto bytes = read_text_file(file);
        REQUIRE(bytes);
        CAPTURE(file);
        for (const std::string& wrong : wrong_places(as_read(*bytes))) CHECK(wrong == "");
    }
}

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
    program.press_key(key::kEnter);  // an item of the search itself
    CHECK(program.app.ui.dialog == kKeysDialog);
    program.press_key(key::kEscape);
    CHECK(program.app.ui.dialog == kNoDialog);
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
