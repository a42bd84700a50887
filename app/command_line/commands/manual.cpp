// tactspace manual: the manual as one page.

#include "app/manual/manual.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "app/command_line/command_line.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/document/workspace.h"
#include "app/pictures/pictures.h"
#include "app/session/program_version.h"
#include "app/subset/subset.h"
#include "app/window/window.h"
#include "assets/assets.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/set/parameter_paths.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

constexpr const char* kTwelve = "sets/pm_2023_twelve.tactspace.json";
constexpr const char* kLibrary = "library/library.tactspace.json";

struct ManualView {
    std::string_view name;
    const char* set;
    PictureView view;
    const char* pattern;
    const char* with;  // empty: no other
    std::optional<Stage> stage;
    double at_s;
    int width;
    int height;
    void (*arrange)(ViewSnapshot&) = nullptr;
};

void show_editor(ViewSnapshot& still) { still.app.layout.maximised = Pane::editor; }

void show_subset(ViewSnapshot& still) {
    still.app.layout.maximised = Pane::matrix;
    still.app.layout.bench = BenchTab::subset;
    still.app.picking.count = 4;
}

const auto kManualViews = std::to_array<ManualView>({
    {"window", kTwelve, PictureView::window, "LH-4-full", "", {}, 0.2, 1280, 800},
    {"editor", kLibrary, PictureView::window, "Take-off", "", {}, 0.0, 880, 560, show_editor},
    {"stages", kTwelve, PictureView::physiology, "LH-4-full", "", {}, 0.2, 880, 900},
    {"receptors", kTwelve, PictureView::physiology, "LH-4-full", "", Stage::receptors, 0.13, 880,
     330},
    {"pair", kTwelve, PictureView::physiology, "L-0-full", "H-0-full", Stage::brain, 0.2, 880, 480},
    {"map", kTwelve, PictureView::space, "LH-4-full", "", {}, 0.0, 880, 560},
    {"matrix", kTwelve, PictureView::matrix, "LH-4-full", "", {}, 0.0, 760, 540},
    {"subset", kTwelve, PictureView::window, "LH-4-full", "", {}, 0.0, 880, 560, show_subset},
});

// Pictures that no pane of the window has.
struct ManualDrawing {
    std::string_view name;
    int width;
    int height;
    Picture (*draw)(const PatternSet& twelve, const PictureSize& size);
};

Picture draw_firing_of_twelve(const PatternSet& twelve, const PictureSize& size) {
    const auto found = std::ranges::find(twelve.vibrations, "H-4-full", &Vibration::name);
    return firing_picture(*found, twelve.model.coding, size);
}

Picture draw_tables(const PatternSet& twelve, const PictureSize& size) {
    return tables_picture(twelve.model.coding.tables, size);
}

// Each turned onto that of PM.
Picture draw_maps(const PatternSet& twelve, const PictureSize& size) {
    const std::array metrics{Metric::pm, Metric::spqi, Metric::rmse, Metric::msm};
    const auto matrices = *compared_matrices(twelve, metrics, nullptr, {});
    const auto paths = paths_along(twelve.vibrations, PatternParameter::modulation);
    std::vector<PerceptualSpace> spaces;
    std::vector<MapPanel> panels;
    spaces.reserve(metrics.size());
    for (std::size_t k = 0; k < metrics.size(); ++k) {
        spaces.push_back(nonmetric_mds(matrices[k], standard_mds_params(matrices[k].size, 3)));
        if (k > 0) {
            spaces[k].points = procrustes(spaces[k].points, spaces[0].points).aligned;
        }
        panels.push_back(
            {&matrices[k], &spaces[k], {.paths = paths, .quantity = traits(metrics[k]).name}});
    }
    return space_panels_picture(twelve, panels, "The twelve by four metrics", "", size);
}

const auto kManualDrawings = std::to_array<ManualDrawing>({
    {"firing", 880, 520, draw_firing_of_twelve},
    {"tables", 880, 420, draw_tables},
    {"maps", 880, 760, draw_maps},
});

// A view or a drawing, on one of the two grounds.
PictureSize size_of(const auto& wanted, bool dark) {
    PictureSize size;
    size.width = wanted.width;
    size.height = wanted.height;
    size.dark = dark;
    size.format = PictureFormat::svg;
    size.svg_ids = std::string(wanted.name) + (dark ? "-dark-" : "-light-");
    return size;
}

ManualPicture drawn_for_manual(const ManualDrawing& wanted) {
    PatternSet twelve = *parse_set(asset(kTwelve), kTwelve, {});
    give_looks(twelve);
    const auto svg = [&](bool dark) {
        const PictureSize size = size_of(wanted, dark);
        return std::get<Svg>(wanted.draw(twelve, size)).text;
    };
    return {svg(false), svg(true)};
}

std::size_t place_in(const PatternSet& set, std::string_view name) {
    const auto found = std::ranges::find(set.vibrations, name, &Vibration::name);
    return static_cast<std::size_t>(found - set.vibrations.begin());
}

// The subset is picked as in a window, whose frames take what was answered until nothing is busy.
void pick_subset(ViewSnapshot& still) {
    auto& [app, scrolled] = still;
    app.ui.wake = [] {};
    for (int quiet = 0; quiet < 2; ++quiet) {
        follow_subset(app.ui, app.work, app.layout, app.shown_map, app.picking);
        if (!is_subset_busy(app.picking)) continue;
        quiet = -1;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    app.ui.wake = {};
}

Expected<ManualPicture> drawn_view(const ManualView& wanted) {
    Expected<PatternSet> set = parse_set(asset(wanted.set), wanted.set, {});
    if (!set) return set.error();
    give_looks(*set);
    if (wanted.arrange == show_editor) {  // the others would only be waited for
        const std::size_t alone[] = {place_in(*set, wanted.pattern)};
        *set = part_of(*set, alone);
    }
    ViewChoice choice;
    choice.view = wanted.view;
    choice.pattern = place_in(*set, wanted.pattern);
    choice.stage = wanted.stage;
    if (*wanted.with != '\0') choice.pinned = place_in(*set, wanted.with);
    const auto view = opened_view(*set, choice);
    if (wanted.arrange != nullptr) wanted.arrange(*view);
    const auto svg = [&](bool dark) {
        const PictureSize size = size_of(wanted, dark);
        return std::get<Svg>(view_picture(*view, wanted.view, wanted.at_s, size)).text;
    };
    if (view->app.layout.bench == BenchTab::subset) pick_subset(*view);
    return ManualPicture{svg(false), svg(true)};
}

Expected<ManualPicture> picture_for_manual(const std::string& name) {
    std::string names;
    for (const ManualView& view : kManualViews) {
        if (view.name == name) return drawn_view(view);
        names += (names.empty() ? "" : ", ") + std::string(view.name);
    }
    for (const ManualDrawing& drawing : kManualDrawings) {
        if (drawing.name == name) return drawn_for_manual(drawing);
        names += ", " + std::string(drawing.name);
    }
    return Error{"expected one of the pictures " + names + ", got \"" + name + "\""};
}

ManualSource manual_source() {
    ManualSource source;
    for (const CommandHelp& command : command_help()) {
        source.command_line.push_back({command.name, command.summary, command.text});
    }
    for (const Command& command : commands()) {
        const std::string_view menu = command.menu;
        if (menu.empty() || menu == kExampleMenu) continue;  // a chapter lists the sets
        source.commands.push_back({command.menu, command.name, shortcut_text(command.shortcut)});
    }
    for (const KeyRow& row : keys_and_mouse()) source.keys.push_back({row.keys, row.what});
    source.picture = picture_for_manual;
    source.program = kProgramVersion;
    return source;
}

}  // namespace

Expected<Done> run(const ManualCommand& command) {
    if (const auto writable = writable_result(command.out); !writable) return writable.error();
    const Expected<std::string> page = manual_page(manual_source());
    if (!page) return page.error();
    if (const auto written = write_atomically(command.out, *page); !written) return written;
    std::cerr << "tactspace: wrote " << command.out.string() << "\n";
    return Done{};
}

}  // namespace tact
