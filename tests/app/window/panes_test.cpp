// Every pane of every workspace, at every size of text: its content is visible or can be scrolled
// to, and a scrolling part has room for at least one row.

#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "app/window/window.h"
#include "tests/support/felt_program.h"
#include "tests/support/reach.h"
#include "tests/support/scenes.h"

namespace panes_test {

using namespace tact;

namespace {

bool is_of_panes(const Scene& scene) {
    for (const char* other : {"dialog, ", "menu ", "popup ", "tooltip ", "palette"}) {
        if (scene.name.starts_with(other)) return false;
    }
    return !scene.is_costly;
}

// Windows on screen, clipped to their parents.
std::vector<std::string> faults_on_screen() {
    std::vector<std::string> faults;
    const ImRect screen({}, ImGui::GetIO().DisplaySize);
    for (const ImGuiWindow* one : ImGui::GetCurrentContext()->Windows) {
        if (!one->WasActive || one->Hidden || (one->Flags & ImGuiWindowFlags_Tooltip) != 0)
            continue;
        const std::string name = one->Name;
        if (one == one->RootWindow && !screen.Contains(one->Rect())) {
            faults.push_back(name + " leaves the screen");
        }
        const std::string lost = out_of_reach(*one);
        if (!lost.empty()) faults.push_back(name + ": " + lost);
    }
    return faults;
}

}  // namespace

TEST_CASE("panes: at any size of text nothing in a pane is out of reach" *
          doctest::test_suite("long")) {
    SceneWindow window;
    for (const ImVec2 size : {ImVec2{1600.0F, 1000.0F}, ImVec2{1280.0F, 720.0F}}) {
        for (const float scale : {1.0F, 1.5F, 2.0F}) {
            CAPTURE(size.x);
            CAPTURE(scale);
            window.resize(size, scale);
            for (const Scene& scene : scenes()) {
                if (!is_of_panes(scene)) continue;
                CAPTURE(scene.name);
                window.show(scene);
                window.settle();
                for (const std::string& fault : faults_on_screen()) FAIL_CHECK(fault);
            }
        }
    }
}

// Two primary buttons would defeat their purpose.
TEST_CASE("panes: each has one primary button at most, and a dialog over them one" *
          doctest::test_suite("long")) {
    SceneWindow window;
    window.resize({1600.0F, 1000.0F}, 1.0F);
    std::size_t primaries = 0;
    for (const Scene& scene : scenes()) {
        if (scene.is_costly) continue;
        CAPTURE(scene.name);
        window.show(scene);
        window.settle();
        const auto named = [&](const char* begin) {
            std::vector<Place> all;
            for (const auto& [name, place] : window.places) {
                if (name.starts_with(begin)) all.push_back(place);
            }
            return all;
        };
        const std::vector<Place> buttons = named("primary:");
        primaries += buttons.size();
        const bool is_dialog = scene.name.starts_with("dialog, ");
        const auto within = [&](const Place& area) {
            return std::ranges::count_if(buttons, [&](const Place& button) {
                return area.min.x <= button.min.x && button.max.x <= area.max.x &&
                       area.min.y <= button.min.y && button.max.y <= area.max.y;
            });
        };
        for (const Place& pane : named("pane:")) CHECK(within(pane) <= (is_dialog ? 2 : 1));
    }
    CHECK(primaries > 20);
}

// The level, the stop button and the choice of device.
TEST_CASE("panes: the bar keeps its level, its device and Play at any size of text") {
    FeltProgram program;
    for (const ImVec2 size : {ImVec2{1600.0F, 1000.0F}, ImVec2{1280.0F, 720.0F}}) {
        for (const float scale : {1.0F, 1.5F, 2.0F}) {
            CAPTURE(size.x);
            CAPTURE(scale);
            program.resize(size, scale);
            for (const char* name : {"level", "device", "transport:play"}) {
                CAPTURE(name);
                REQUIRE(program.shows(name));
                CHECK(program.at(name).min.x >= 0.0F);
                CHECK(program.at(name).max.x <= size.x);
                CHECK(program.at(name).max.y <= size.y);
            }
        }
    }
}

TEST_CASE("panes: a window as narrow as a phone shows one at a time, whatever asks for it") {
    Program program(short_patterns(3));
    program.resize({1280.0F, 720.0F}, 1.0F);
    CHECK_FALSE(program.shows("pane button:Map"));
    program.resize({390.0F, 844.0F}, 1.0F);
    for (const auto& [button, pane] : {std::pair{"List", "pane:Patterns"},
                                       {"Editor", "pane:Editor"},
                                       {"Map", "pane:Perceptual space"},
                                       {"Stages", "pane:Physiology"},
                                       {"Answers", "pane:Matrix"}}) {
        CAPTURE(button);
        program.click(std::string("pane button:") + button);
        REQUIRE(program.shows(pane));
        CHECK(program.at(pane).max.x - program.at(pane).min.x > 370.0F);
        CHECK(program.at(pane).max.y <= program.at("pane button:List").min.y);
    }
    CHECK_FALSE(program.shows("pane:Perceptual space"));
    program.click("pane button:List");
    show_tab(program.app, BenchTab::subset);
    program.settle();
    CHECK(program.at("pane button:Answers").value == "chosen");
    program.app.layout.maximised = Pane::space;
    program.settle();
    CHECK(program.shows("pane:Perceptual space"));
    CHECK_FALSE(program.app.layout.maximised);
}

}  // namespace panes_test
