// Tab or a key reaches everything that the mouse can press; and Tab follows reading order.

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/ui/ui.h"
#include "tests/support/scenes.h"

namespace keyboard_test {

using namespace tact;

namespace {

// Items that are not stops, by the beginning of their name, and the key or item that does the same.
constexpr auto kOtherwise = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"menu:", "Ctrl+P finds every command of the menus"},
    {"workspace:", "Ctrl+1 to Ctrl+4, F5"},
    {"slider:", "the entry beside it"},
    {"stepper:", "Up and Down in the entry before it"},
    {"row:", "arrows within the list"},
    {"point:", "the rows of the list"},
    {"view:", "the rows of the list; a tab of its own for a pair"},
    {"plot:", "comma, full stop and Home move through time"},
    {"strip:", "N and Shift+N choose a point, its fields change it"},
    {"grip:", "the fields of attack and release"},
    {"grid ", "the names of the stages open it large"},
    {"network ", "the names of the receptors"},
    {"curve ", "the number of patterns to pick"},
    {"study m", "matrix and map are looked at: Export CSV has their numbers"},
    {"generate:preview ", "Space plays it, once it is in the list"},
    {"answer:", "Tab and arrows move the mark along the answers, Enter takes it"},
    {"splitter:", "F7 and F8 make the pane in use larger, with Shift smaller"},
});

bool has_other_way(const std::set<std::string>& names) {
    return std::ranges::any_of(names, [](const std::string& name) {
        return std::ranges::any_of(kOtherwise,
                                   [&](const auto& way) { return name.starts_with(way.first); });
    });
}

std::string listed(const std::set<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += name + " ";
    return all;
}

// For each item that the mouse can press: the names with their middle on it.
std::map<ImGuiID, std::set<std::string>> pressable(Program& program) {
    const std::map<std::string, Place> places = program.places;
    const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    const ImGuiWindow* over = popups.empty() ? nullptr : popups.back().Window;
    const ImRect within = over != nullptr ? over->Rect() : ImRect({}, ImGui::GetIO().DisplaySize);
    std::map<ImGuiID, std::set<std::string>> found;
    for (const auto& [name, place] : places) {
        const ImVec2 at = place.middle();
        const bool is_area = name == "pointer" || name.starts_with("pane:");
        if (is_area || !within.Contains(at)) continue;
        program.window.move(at);
        program.frame();
        const ImGuiContext& imgui = *ImGui::GetCurrentContext();
        if (imgui.HoveredId != 0 && !imgui.HoveredIdDisabled) found[imgui.HoveredId].insert(name);
    }
    program.window.move({-100.0F, -100.0F});
    program.settle();
    return found;
}

struct Stop {
    ImGuiID id = 0;
    const ImGuiWindow* pane = nullptr;
    Place place;
};

// Stops of Tab, once around; a stop without a visible frame is left out.
std::vector<Stop> round_trip(Program& program, std::vector<std::string>& faults) {
    std::vector<Stop> stops;
    std::set<ImGuiID> seen;
    constexpr int kMost = 300;
    for (int k = 0; k < kMost; ++k) {
        program.window.press(key::kTab);
        while (pending(program.window.input)) program.frame();
        program.frame();
        const ImGuiContext& imgui = *ImGui::GetCurrentContext();
        if (imgui.NavWindow == nullptr || !program.shows("focus")) {
            faults.push_back("the focus is not seen after Tab " + std::to_string(k + 1));
            return stops;
        }
        if (!seen.insert(imgui.NavId).second) break;
        stops.push_back({imgui.NavId, imgui.NavWindow->RootWindow, program.at("focus")});
    }
    return stops;
}

// In the same row and to the right, further down, or at the top of the next column.
bool follows(const Place& a, const Place& b) {
    const bool same_row = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y) >
                          0.5F * std::min(a.max.y - a.min.y, b.max.y - b.min.y);
    if (same_row) return b.min.x >= a.min.x;
    return b.min.y > a.min.y || b.min.x >= a.max.x;
}

// Running work has a Cancel button, which disappears at its end.
void wait_for_rest(Program& program) {
    const auto works = [](const auto& place) { return place.first.starts_with("progress:"); };
    const auto until = end_of_patience();
    while (std::ranges::any_of(program.places, works) && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
}

std::vector<std::string> faults_of(SceneWindow& window, const Scene& scene,
                                   std::optional<Pane> alone) {
    window.show(scene);
    if (alone) window.app.layout.maximised = alone;
    window.wait_for_exact_map();
    wait_for_rest(window);
    std::vector<std::string> faults;
    const auto things = pressable(window);
    const std::vector<Stop> stops = round_trip(window, faults);
    const auto name_of = [&](const Stop& stop) {
        const auto found = things.find(stop.id);
        const ImVec2 at = stop.place.min;
        return (found == things.end() ? std::string("something ") : listed(found->second)) + "at " +
               std::to_string(static_cast<int>(at.x)) + ", " +
               std::to_string(static_cast<int>(at.y));
    };
    for (const auto& [id, names] : things) {
        const bool reached = std::ranges::find(stops, id, &Stop::id) != stops.end();
        if (!reached && !has_other_way(names)) faults.push_back("not reached: " + listed(names));
    }
    for (std::size_t k = 1; k < stops.size(); ++k) {
        const bool same_pane = stops[k - 1].pane == stops[k].pane;
        if (same_pane && !follows(stops[k - 1].place, stops[k].place)) {
            faults.push_back("out of order: " + name_of(stops[k - 1]) + " before " +
                             name_of(stops[k]));
        }
    }
    return faults;
}

bool is_of(const Scene& scene, const std::vector<std::string>& beginnings) {
    return std::ranges::any_of(beginnings,
                               [&](const std::string& one) { return scene.name.starts_with(one); });
}

// High enough that Tab never scrolls: places stay the same.
struct HighWindow : SceneWindow {
    HighWindow() { resize({1600.0F, 2600.0F}, 1.0F); }

    // `alone`: a pane that fills the window, the others being covered by other scenes.
    void check(const std::vector<std::string>& beginnings,
               std::optional<Pane> alone = std::nullopt) {
        for (const Scene& scene : scenes()) {
            // In the palette, letters and arrows choose; in a question, the mark does.
            const bool has_own_way =
                scene.name == "dialog, palette" || scene.name == "dialog, question";
            if (!is_of(scene, beginnings) || has_own_way) continue;
            CAPTURE(scene.name);
            for (const std::string& fault : faults_of(*this, scene, alone)) {
                CAPTURE(fault);
                CHECK(fault.empty());
            }
        }
    }
};

}  // namespace

TEST_CASE("keyboard: in every workspace Tab reaches what can be pressed, as one reads" *
          doctest::test_suite("long")) {
    HighWindow().check({"design", "select", "physiology", "study, ", "lesson", "presenting"});
}

TEST_CASE("keyboard: on every tab of the bench Tab reaches what can be pressed, as one reads" *
          doctest::test_suite("long")) {
    std::vector<std::string> beginnings{"too close", "how sure", "training"};
    for (const BenchRow& row : kBenchTabs) beginnings.emplace_back(row.key);
    HighWindow().check(beginnings, Pane::matrix);
}

TEST_CASE("keyboard: in every dialog and popup Tab reaches what can be pressed, as one reads" *
          doctest::test_suite("long")) {
    HighWindow().check({"dialog, ", "popup "});
}

TEST_CASE("keyboard: Tab moves the mark of a question along its answers, and around") {
    Program program(short_patterns(1));
    ask(program.app.ui, {.title = "Which?", .text = "One of them.", .answers = {{"A"}, {"B"}}});
    program.settle();
    CHECK(program.at("answer:A").value == "marked");
    program.press_key(key::kTab);
    CHECK(program.at("answer:B").value == "marked");
    CHECK(program.at("answer:A").value.empty());
    program.press_key(key::kTab);
    CHECK(program.at("answer:A").value == "marked");
    program.press_key(key::kTab, false, true);
    CHECK(program.at("answer:B").value == "marked");
}

}  // namespace keyboard_test
