// The groups in the program's real frames: the tree follows the map, the line cuts it, and one of
// each group becomes the subset.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace groups_panel_test {

using namespace tact;

namespace {

struct GroupsBench {
    Program program{short_patterns(9)};
    App& app = program.app;

    GroupsBench() {
        program.compute_map();
        app.layout.bench = BenchTab::subset;
        app.picking.view = SubsetView::groups;
        wait([this] { return shown_groups(app.shown_map, app.picking) != nullptr; });
    }

    template <class Arrived>
    void wait(const Arrived& arrived) {
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program.frame();
        } while (!arrived());
        program.settle();
    }
    std::size_t count() const { return std::stoul(program.at("groups:count").value); }
};

}  // namespace

TEST_CASE("groups panel: the tree is the model's, its groups have colours in the map") {
    GroupsBench bench;
    App& app = bench.app;
    const LiveMap& map = *app.shown_map.transition.shown;
    const SetGroups expected =
        groups_of_set(*map.request.set, map.prediction.pm, unfelt(map.prediction.codes));
    CHECK(app.picking.groups->groups == expected);
    CHECK(bench.count() == usual_group_count(9));
    const MapMarks marks = subset_marks(app.ui.theme, app.layout, app.shown_map, app.picking);
    REQUIRE(marks.looks.size() == 9);
    const CutGroups& cut = cut_groups(app.picking);
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool alone = cut.groups[cut.group_of[i]].members.size() == 1 &&
                               cut.groups[cut.group_of[j]].members.size() == 1;
            const bool same_group = cut.group_of[i] == cut.group_of[j];
            CHECK((marks.looks[i] == marks.looks[j]) == (same_group || alone));
        }
    }
}

TEST_CASE("groups panel: the line dragged up leaves fewer groups, a step leaves one more") {
    GroupsBench bench;
    const std::size_t before = bench.count();
    const Place line = bench.program.at("groups:line");
    const Place tree = bench.program.at("groups:tree");
    bench.program.drag(line.middle(), {line.middle().x, tree.min.y + 30.0F}, 4);
    const std::size_t after = bench.count();
    CHECK(after < before);
    REQUIRE(bench.app.picking.cut);
    CHECK(after == group_count(bench.app.picking.groups->groups.tree, *bench.app.picking.cut));
    bench.program.click("stepper:group count more");
    CHECK(bench.count() == after + 1);
    CHECK_FALSE(bench.app.picking.cut);
}

TEST_CASE("groups panel: one of each group is kept as one step, and again for another cut") {
    GroupsBench bench;
    App& app = bench.app;
    const std::vector<PatternGroup> groups = cut_groups(app.picking).groups;
    bench.program.click("button:keep groups");
    CHECK(app.picking.view == SubsetView::pick);
    std::vector<std::size_t> locked;
    for (std::size_t k = 0; k < 9; ++k) {
        if (app.work.document.set.vibrations[k].locked) locked.push_back(k);
    }
    std::vector<std::size_t> central;
    for (const PatternGroup& group : groups) central.push_back(group.central);
    std::ranges::sort(central);
    CHECK(locked == central);
    bench.program.wait_for_exact_map();
    bench.wait([&] {
        const Subset* subset = shown_subset(app.shown_map, app.picking);
        return subset != nullptr && subset->members == central;
    });
    app.picking.view = SubsetView::groups;
    app.picking.group_count = 2;
    bench.wait([&] {
        return app.picking.groups->request.map == app.shown_map.transition.shown &&
               bench.program.at("button:keep groups").value.empty();
    });
    bench.program.click("button:keep groups");
    const auto is_locked = [](const Vibration& vibration) { return vibration.locked; };
    CHECK(std::ranges::count_if(app.work.document.set.vibrations, is_locked) == 2);
    undo(app.ui, app.work);
    undo(app.ui, app.work);
    CHECK(std::ranges::none_of(app.work.document.set.vibrations, is_locked));
    CHECK(app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("groups panel: a click on a group selects all of it") {
    GroupsBench bench;
    App& app = bench.app;
    const CutGroups& cut = cut_groups(app.picking);
    const auto large = std::ranges::max_element(
        cut.groups, {}, [](const PatternGroup& group) { return group.members.size(); });
    REQUIRE(large->members.size() > 1);
    const std::vector<std::size_t> members = large->members;
    const std::size_t central = large->central;
    bench.program.click("group:" + app.work.document.set.vibrations[central].name);
    CHECK(app.work.selection.current == central);
    CHECK(selected_indices(app.work) == members);
}

}  // namespace groups_panel_test
