#include "app/workspaces/workspaces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace workspaces_test {

using namespace tact;

TEST_CASE("workspaces: each comes back as it was left, and can be begun again") {
    Layout layout = first_layout(Arrangement::design);
    Workspaces workspaces;
    layout.left = 0.31F;
    layout.bench = BenchTab::why;
    show_arrangement(Arrangement::select, layout, workspaces);
    CHECK(layout == first_layout(Arrangement::select));
    layout.right = 0.44F;
    show_arrangement(Arrangement::design, layout, workspaces);
    CHECK(layout.left == 0.31F);
    CHECK(layout.bench == BenchTab::why);
    CHECK(layout.arrangement == Arrangement::design);
    show_arrangement(Arrangement::select, layout, workspaces);
    CHECK(layout.right == 0.44F);
}

TEST_CASE("workspaces: the stages fill the window whenever theirs is asked for") {
    Layout layout;
    Workspaces workspaces;
    show_arrangement(Arrangement::physiology, layout, workspaces);
    CHECK(layout.maximised == Pane::physiology);
    layout.maximised.reset();
    show_arrangement(Arrangement::physiology, layout, workspaces);
    CHECK(layout.maximised == Pane::physiology);
    show_arrangement(Arrangement::design, layout, workspaces);
    CHECK_FALSE(layout.maximised);
}

TEST_CASE("workspaces: one's own do not touch those that come with the program") {
    Layout layout = first_layout(Arrangement::design);
    Workspaces workspaces;
    Layout own = layout;
    own.left = 0.2F;
    own.physiology = Fold::closed;
    workspaces.own["large map"] = own;
    layout.left = 0.31F;
    show_own("large map", layout, workspaces);
    CHECK(layout == own);
    layout.left = 0.39F;
    show_arrangement(Arrangement::design, layout, workspaces);
    CHECK(layout.left == 0.31F);
    show_own("no such name", layout, workspaces);
    CHECK(layout.left == 0.31F);
}

TEST_CASE("workspaces: the next start has them all, and heeds nothing odd") {
    Layout layout = first_layout(Arrangement::select);
    Workspaces workspaces;
    layout.right = 0.41F;
    workspaces.left[Arrangement::design] = first_layout(Arrangement::design);
    workspaces.left[Arrangement::design].left_split = 0.66F;
    workspaces.own["a/b 0.5"] = first_layout(Arrangement::physiology);
    std::map<std::string, double> kept{{"zoom", 1.5}, {"own gone/left", 0.2}};
    keep_workspaces(layout, workspaces, kept);
    CHECK(kept.at("zoom") == 1.5);
    CHECK_FALSE(kept.contains("own gone/left"));

    Layout begun;
    Workspaces known;
    restore_workspaces(kept, begun, known);
    CHECK(begun == layout);
    CHECK(known.left == workspaces.left);
    CHECK(known.own.size() == 1);
    CHECK(known.own.contains("a/b 0.5"));

    kept["shown/left"] = 1e9;
    kept.erase("shown/bench subset");
    kept["shown/bench"] = -7.0;
    kept["shown/physiology"] = 99.0;
    kept["shown/right"] = std::numeric_limits<double>::quiet_NaN();
    restore_workspaces(kept, begun, known);
    CHECK(begun.left == 0.40F);
    CHECK(begun.bench == BenchTab::matrix);
    CHECK(begun.physiology == Fold::closed);
    CHECK(begun.right == first_layout(Arrangement::design).right);

    restore_workspaces({}, begun, known);
    CHECK(begun == first_layout(Arrangement::design));
}

TEST_CASE("workspaces: every tab comes back by its name, wherever it stands among the others") {
    std::set<std::string> keys;
    for (const auto& row : kBenchTabs) {
        CAPTURE(row.key);
        CHECK(keys.insert(row.key).second);
        Layout layout = first_layout(Arrangement::design);
        layout.bench = row.tab;
        Workspaces workspaces;
        workspaces.left[Arrangement::select] = first_layout(Arrangement::select);
        workspaces.own["mine"] = layout;
        std::map<std::string, double> kept{{"shown/bench", 3.0}, {"shown/bench gone", 1.0}};
        keep_workspaces(layout, workspaces, kept);
        CHECK(kept.contains(std::string("shown/bench ") + row.key));
        CHECK(kept.contains(std::string("own mine/bench ") + row.key));
        CHECK_FALSE(kept.contains("shown/bench"));
        CHECK_FALSE(kept.contains("shown/bench gone"));
        Layout begun;
        Workspaces known;
        restore_workspaces(kept, begun, known);
        CHECK(begun.bench == row.tab);
        CHECK(known.own["mine"].bench == row.tab);
        CHECK(known.left[Arrangement::select].bench == BenchTab::subset);
    }
}

TEST_CASE("workspaces: a session from before tabs were kept by name opens the tab of its number") {
    Layout begun;
    Workspaces known;
    const auto tab_of = [&](const char* what, double number) {
        restore_workspaces({{std::string("shown/") + what, number}}, begun, known);
        return begun.bench;
    };
    const std::vector<std::string> numbered{"matrix", "candidates", "subset", "compare", "shepard",
                                            "why",    "model",      "device", "library"};
    for (std::size_t k = 0; k < numbered.size(); ++k) {
        const auto row = std::ranges::find(kBenchTabs, numbered[k], &BenchRow::key);
        REQUIRE(row != kBenchTabs.end());
        CHECK(tab_of("bench", static_cast<double>(k)) == row->tab);
    }
    CHECK(tab_of("bench", 99.0) == BenchTab::library);
    CHECK(tab_of("bench", -7.0) == BenchTab::matrix);
    CHECK(tab_of("bench", std::numeric_limits<double>::infinity()) == BenchTab::matrix);
    for (const char* unknown : {"bench of later", "bench ", "bench 3", "benchwhy", "bench Why"}) {
        CAPTURE(unknown);
        CHECK(tab_of(unknown, 1.0) == BenchTab::matrix);
    }
}

TEST_CASE("workspaces: tabs over the panes choose what is shown") {
    Program program(short_patterns(4));
    program.compute_map();
    program.click("workspace:Select");
    CHECK(program.at("workspace:Select").value == "on");
    CHECK(program.at("workspace:Design").value == "off");
    CHECK_FALSE(program.shows("pane:Editor"));
    CHECK(program.shows("pane:Candidates"));
    CHECK(program.shows("pane:Subset"));
    program.press_key(key::kF1 + 1);
    CHECK(program.shows("pane:Patterns"));  // where a name is typed
    program.press_key(key::kEscape);
    program.click("workspace:Select");
    program.click("workspace:Study");
    CHECK(program.shows("pane:Study"));
    CHECK(program.at("workspace:Study").value == "on");
    CHECK(program.at("workspace:Select").value == "off");
    program.click("workspace:Physiology");
    CHECK(program.shows("pane:Physiology"));
    CHECK_FALSE(program.shows("pane:Perceptual space"));
    program.click("workspace:Design");
    CHECK(program.shows("pane:Editor"));
}

TEST_CASE("workspaces: the stages fold to a row, from which each opens, and go away") {
    Program program(short_patterns(4));
    program.compute_map();
    program.wait_for_stages();
    const auto area = [&] {
        const Place map = program.at("pane:Perceptual space");
        return (map.max.x - map.min.x) * (map.max.y - map.min.y);
    };
    const float before = area();
    program.click("stages:fold");
    CHECK(program.app.layout.physiology == Fold::row);
    CHECK(area() > 1.25F * before);
    program.click("label:spikes");
    CHECK(program.app.layout.physiology == Fold::open);
    CHECK(program.app.physiology.view.open == Stage::spikes);
    program.app.layout.physiology = Fold::row;
    program.settle();
    program.click("stages:close");
    CHECK_FALSE(program.shows("pane:Physiology"));
    CHECK(program.app.ui.status.text.find("View") != std::string::npos);
}

TEST_CASE("workspaces: one that is saved by name stands in the menu until it is forgotten") {
    Program program(short_patterns(3));
    program.app.layout.left = 0.33F;
    open_workspace_dialog(program.app.ui, program.app.workspaces);
    program.settle();
    program.type("wide list");
    program.press_key(key::kEnter);
    REQUIRE(program.app.workspaces.own.contains("wide list"));
    CHECK(program.app.ui.dialog == kNoDialog);
    program.press('2', true);
    CHECK(program.app.layout.left != 0.33F);
    show_own("wide list", program.app.layout, program.app.workspaces);
    program.settle();
    CHECK(program.app.layout.left == 0.33F);
    CHECK(program.at("workspace:Design").value == "off");
}

}  // namespace workspaces_test
