// The rows of View: content of the window, and its size.

#include <array>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/lesson/lesson.h"
#include "app/study/study.h"
#include "app/window/window.h"

namespace tact {

namespace {

template <Side kSide>
void show_the_side(App& app) {
    show_side(app.work, kSide);
}

template <Side kSide>
bool shows_side(const App& app) {
    return shown_side(app.work) == kSide;
}

template <BenchTab kTab>
void show_bench(App& app) {
    show_tab(app, kTab);
}

template <Arrangement kArrangement>
void show_the_workspace(App& app) {
    show_workspace(app, kArrangement);
}

template <Arrangement kArrangement>
bool shows_workspace(const App& app) {
    return is_workspace(app, kArrangement);
}

template <Fold kFold>
void fold_to(App& app) {
    fold_physiology(app, kFold);
}

template <Fold kFold>
bool is_folded_to(const App& app) {
    return app.layout.physiology == kFold;
}

constexpr auto kLookCommands = std::to_array<Command>({
    {"View", "Design", ctrl('1'), always, show_the_workspace<Arrangement::design>,
     shows_workspace<Arrangement::design>, "workspace layout columns map"},
    {"View", "Select", ctrl('2'), always, show_the_workspace<Arrangement::select>,
     shows_workspace<Arrangement::select>, "workspace layout candidates subset map"},
    {"View", "Physiology", ctrl('3'), always, show_the_workspace<Arrangement::physiology>,
     shows_workspace<Arrangement::physiology>, "workspace layout stages"},
    {"View", "Study", ctrl('4'), always, [](App& app) { open_study(app.layout, app.studying); },
     [](const App& app) { return app.studying.is_open; },
     "workspace ratings people experiment design participants"},
    {"View", "Present", special(key::kF1 + 4), always, present,
     [](const App& app) { return is_presenting(app.lesson); },
     "lecture projector full screen slides clicker tour lesson"},
    {"View",
     "Save workspace as...",
     {},
     always,
     [](App& app) { open_workspace_dialog(app.ui, app.workspaces); },
     nullptr,
     "layout panes name keep"},
    {"View", "Reset the workspace", {}, always, reset_workspace, nullptr, "layout columns"},
    {"View", "Maximise or restore", special(key::kF1 + 5), always, maximise_or_restore,
     [](const App& app) { return app.layout.maximised.has_value(); },
     "restore full size large window"},
    {"View", "Wider pane", special(key::kF1 + 6), has_bars, [](App& app) { ++app.in_use.wider; },
     nullptr, "size splitter column"},
    {"View", "Narrower pane", special(key::kF1 + 6, true), has_bars,
     [](App& app) { --app.in_use.wider; }, nullptr, "size splitter column"},
    {"View", "Higher pane", special(key::kF1 + 7), has_bars, [](App& app) { ++app.in_use.higher; },
     nullptr, "size splitter taller row"},
    {"View", "Lower pane", special(key::kF1 + 7, true), has_bars,
     [](App& app) { --app.in_use.higher; }, nullptr, "size splitter shorter row"},
    {"View",
     "Stages in the middle",
     {},
     always,
     fold_to<Fold::open>,
     is_folded_to<Fold::open>,
     "physiology unfold"},
    {"View",
     "Stages in one row",
     {},
     always,
     fold_to<Fold::row>,
     is_folded_to<Fold::row>,
     "physiology fold"},
    {"View",
     "No stages",
     {},
     always,
     fold_to<Fold::closed>,
     is_folded_to<Fold::closed>,
     "physiology close hide"},
    {"View", "Textbook over the stages", plain('e'), always,
     [](App& app) { app.physiology.view.textbook = !app.physiology.view.textbook; },
     [](const App& app) { return app.physiology.view.textbook; },
     "measured facts evidence sources physiology"},
    {"View",
     "Reset view of the space",
     {},
     always,
     [](App& app) { app.shown_map.camera = SpaceCamera{}; },
     nullptr,
     "camera"},
    {"View", "Move points of the space", plain('m'), always,
     [](App& app) { app.shown_map.move_tool = !app.shown_map.move_tool; },
     [](const App& app) { return app.shown_map.move_tool; }, "tool put drag map search"},
    {"View", "Frame the selection in the space", plain('f'), has_selection,
     [](App& app) { app.shown_map.frame_asked = true; }, nullptr, "zoom camera map focus"},
    {"View",
     "Lock the view of the space",
     {},
     always,
     [](App& app) { app.shown_map.camera.locked = !app.shown_map.camera.locked; },
     [](const App& app) { return app.shown_map.camera.locked; },
     "camera map turn"},
    {"View",
     "Dark",
     {},
     always,
     [](App& app) { set_theme(app.ui, true); },
     [](const App& app) { return app.ui.dark; },
     "theme"},
    {"View",
     "Light",
     {},
     always,
     [](App& app) { set_theme(app.ui, false); },
     [](const App& app) { return !app.ui.dark; },
     "theme"},
    {"View", "Larger text", ctrl('+'), always, [](App& app) { step_text_scale(app.ui, 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Smaller text", ctrl('-'), always,
     [](App& app) { step_text_scale(app.ui, 1.0F / 1.1F); }, nullptr, "zoom scale"},
    {"View", "Default text size", ctrl('0'), always,
     [](App& app) { set_text_scale(app.ui, 1.0F); }},
    {"View",
     "Motion",
     {},
     always,
     [](App& app) { app.ui.motion = !app.ui.motion; },
     [](const App& app) { return app.ui.motion; },
     "animation"},
    {"View", "Bring hints back", {}, always, [](App& app) { app.ui.dismissed_hints.clear(); }},
});

// Rows behind that of a tab.
constexpr auto kBehindTabs = std::to_array<std::pair<BenchTab, Command>>({
    {BenchTab::candidates,
     {"View",
      "Only picked",
      {},
      always,
      [](App& app) { app.work.selection.only_picked = !app.work.selection.only_picked; },
      [](const App& app) { return app.work.selection.only_picked; },
      "filter list subset"}},
    {BenchTab::model,
     {"View",
      "Train on ratings",
      {},
      always,
      show_training,
      nullptr,
      "fit parameters people optimum search model"}},
});

constexpr auto kSideCommands = std::to_array<Command>({
    {"View",
     "Intended and measured",
     {},
     always,
     show_the_side<Side::both>,
     shows_side<Side::both>,
     "both recordings twins"},
    {"View",
     "Intended only",
     {},
     always,
     show_the_side<Side::intended>,
     shows_side<Side::intended>,
     "IPS map patterns"},
    {"View",
     "Measured only",
     {},
     always,
     show_the_side<Side::measured>,
     shows_side<Side::measured>,
     "MPS map recordings twins"},
});

template <std::size_t... kPlaces>
std::vector<Command> with_tabs(std::index_sequence<kPlaces...>) {
    std::vector<Command> all(kLookCommands.begin(), kLookCommands.end());
    const auto add = [&all](std::size_t place, void (*show)(App&)) {
        const auto& row = kBenchTabs[place];
        all.push_back({"View", row.command, {}, always, show, nullptr, row.words});
        for (const auto& [tab, command] : kBehindTabs) {
            if (tab == row.tab) all.push_back(command);
        }
    };
    (add(kPlaces, show_bench<kBenchTabs[kPlaces].tab>), ...);
    all.insert(all.end(), kSideCommands.begin(), kSideCommands.end());
    return all;
}

}  // namespace

std::span<const Command> view_commands() {
    static const std::vector<Command> all =
        with_tabs(std::make_index_sequence<kBenchTabs.size()>());
    return all;
}

}  // namespace tact
