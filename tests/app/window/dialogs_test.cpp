// Every dialog, at every size of text: its buttons are visible, and the rest can be scrolled to.

#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/reach.h"
#include "tests/support/scenes.h"

namespace dialogs_test {

using namespace tact;

namespace {

struct Screen {
    ImVec2 size;
    float scale;
};

// In scenes without a dialog, nothing lies over the panes.
const ImGuiWindow* dialog_on_screen() {
    const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    return popups.empty() ? nullptr : popups.front().Window;
}

// Items that end a dialog, by the beginning of their name.
bool is_end(std::string_view name) {
    for (const char* end :
         {"button:choose", "button:cancel", "button:close", "button:back", "button:add candidates",
          "button:replace generated", "button:generate all the same", "answer:"}) {
        if (name.starts_with(end) && name != "button:cancel export") return true;
    }
    return false;
}

// Places of items are noted in whole pixels.
bool is_within(const Place& place, const ImRect& area) {
    return place.min.x >= area.Min.x - 1.0F && place.min.y >= area.Min.y - 1.0F &&
           place.max.x <= area.Max.x + 1.0F && place.max.y <= area.Max.y + 1.0F;
}

std::vector<std::string> faults_of(const SceneWindow& window, const ImGuiWindow& dialog) {
    std::vector<std::string> faults;
    const ImRect screen({}, ImGui::GetIO().DisplaySize);
    if (!screen.Contains(dialog.Rect())) faults.push_back("the dialog leaves the screen");
    int ends = 0;
    for (const auto& [name, place] : window.places) {
        if (!is_end(name)) continue;
        ++ends;
        if (!is_within(place, dialog.InnerRect)) faults.push_back(name + " is out of sight");
    }
    if (ends == 0) faults.push_back("it has no end");
    for (const ImGuiWindow* one : ImGui::GetCurrentContext()->Windows) {
        if (!one->WasActive || one->RootWindow != &dialog) continue;
        const std::string lost = out_of_reach(*one);
        if (!lost.empty()) faults.push_back(std::string(one->Name) + ": " + lost);
    }
    return faults;
}

}  // namespace

TEST_CASE("dialogs: at any size of text the buttons are in sight, and nothing is out of reach" *
          doctest::test_suite("long")) {
    SceneWindow window;
    for (const Screen& screen :
         {Screen{{1600.0F, 1000.0F}, 1.0F}, Screen{{1280.0F, 720.0F}, 1.0F},
          Screen{{1600.0F, 1000.0F}, 1.5F}, Screen{{1280.0F, 720.0F}, 1.5F},
          Screen{{1600.0F, 1000.0F}, 2.0F}, Screen{{1280.0F, 720.0F}, 2.0F}}) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.scale);
        window.resize(screen.size, screen.scale);
        for (const Scene& scene : scenes()) {
            const bool is_dialog = scene.name.starts_with("dialog, ") &&
                                   scene.name != "dialog, palette";  // Esc leaves that
            if (!is_dialog) continue;
            CAPTURE(scene.name);
            window.show(scene);
            window.settle();
            const ImGuiWindow* dialog = dialog_on_screen();
            CHECK_MESSAGE(dialog != nullptr, "no dialog");
            if (dialog == nullptr) continue;
            for (const std::string& fault : faults_of(window, *dialog)) FAIL_CHECK(fault);
        }
    }
}

TEST_CASE("dialogs: Generate scrolls down to its last row, and its buttons stay where they are") {
    SceneWindow window;
    window.resize({1280.0F, 720.0F}, 2.0F);
    window.press('g', true);
    const Place add = window.at("button:add candidates");
    CHECK(window.at("generate:detectable").min.y > add.min.y);  // further down
    window.window.move(window.at("generate:amplitude values").middle());
    for (int k = 0; k < 200; ++k) {
        push(window.window.input, {window.window.now_s, MouseWheel{0.0F, -1.0F}});
    }
    window.settle();
    CHECK(window.at("generate:detectable").max.y <= add.min.y);
    CHECK(window.at("button:add candidates").min.y == add.min.y);
}

}  // namespace dialogs_test
