#include "app/workspaces/workspaces.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

namespace {

constexpr std::array kArrangements{
    std::pair{Arrangement::design, std::string_view("design")},
    std::pair{Arrangement::select, std::string_view("select")},
    std::pair{Arrangement::physiology, std::string_view("physiology")}};
constexpr std::string_view kOwn = "own ";
constexpr std::string_view kBench = "bench ";  // and the key of the tab

// Before December 2026 a tab was kept by its place among these.
constexpr std::array kNumberedTabs{BenchTab::matrix,  BenchTab::candidates, BenchTab::subset,
                                   BenchTab::compare, BenchTab::shepard,    BenchTab::why,
                                   BenchTab::model,   BenchTab::device,     BenchTab::library};

struct Share {
    const char* name;
    float Layout::*share;
    float least, most;
};
constexpr std::array kShares{Share{"left", &Layout::left, 0.14F, 0.40F},
                             Share{"right", &Layout::right, 0.18F, 0.58F},
                             Share{"left_split", &Layout::left_split, 0.15F, 0.80F},
                             Share{"right_split", &Layout::right_split, 0.20F, 0.85F},
                             Share{"band", &Layout::band, 0.20F, 0.70F}};

void keep(const Layout& layout, const std::string& name, std::map<std::string, double>& kept) {
    for (const Share& share : kShares) {
        kept[name + "/" + share.name] = static_cast<double>(layout.*share.share);
    }
    const char* tab = kBenchTabs[static_cast<std::size_t>(layout.bench)].key;
    kept[name + "/" + std::string(kBench) + tab] = 1.0;
    kept[name + "/physiology"] = static_cast<double>(layout.physiology);
    kept[name + "/arrangement"] = static_cast<double>(layout.arrangement);
}

// What was written by hand, or by a later version, is not trusted.
template <class Choice>
Choice choice(double number, Choice last) {
    const double most = static_cast<double>(last);
    return std::isfinite(number) ? static_cast<Choice>(std::lround(std::clamp(number, 0.0, most)))
                                 : Choice{};
}

void take(std::string_view what, double number, Layout& layout) {
    for (const Share& share : kShares) {
        if (what == share.name && std::isfinite(number)) {
            layout.*share.share = std::clamp(static_cast<float>(number), share.least, share.most);
        }
    }
    for (const auto& row : kBenchTabs) {
        if (what.starts_with(kBench) && what.substr(kBench.size()) == row.key)
            layout.bench = row.tab;
    }
    if (what == "bench") layout.bench = kNumberedTabs[choice(number, kNumberedTabs.size() - 1)];
    if (what == "physiology") layout.physiology = choice(number, Fold::closed);
    if (what == "arrangement") layout.arrangement = choice(number, Arrangement::physiology);
}

}  // namespace

Layout first_layout(Arrangement arrangement) {
    switch (arrangement) {
        case Arrangement::select:
            return {.left = 0.34F,
                    .right = 0.27F,
                    .maximised = {},
                    .bench = BenchTab::subset,
                    .arrangement = arrangement,
                    .physiology = Fold::closed};
        case Arrangement::physiology:
            return {.left = 0.18F,
                    .right = 0.24F,
                    .maximised = Pane::physiology,
                    .arrangement = arrangement};
        case Arrangement::design:
            break;
    }
    return {.left = 0.165F,
            .right = 0.28F,
            .maximised = {},
            .arrangement = arrangement,
            .physiology = Fold::row};
}

namespace {

// One of a person's own is as it was saved, whatever was done to it since.
void leave(const Layout& layout, Workspaces& workspaces) {
    if (workspaces.shown.empty()) workspaces.left[layout.arrangement] = layout;
    workspaces.shown.clear();
}

}  // namespace

void show_arrangement(Arrangement arrangement, Layout& layout, Workspaces& workspaces) {
    leave(layout, workspaces);
    const auto kept = workspaces.left.find(arrangement);
    layout = kept == workspaces.left.end() ? first_layout(arrangement) : kept->second;
    layout.maximised = first_layout(arrangement).maximised;
}

void show_own(const std::string& name, Layout& layout, Workspaces& workspaces) {
    const auto found = workspaces.own.find(name);
    if (found == workspaces.own.end()) return;
    const Layout own = found->second;
    leave(layout, workspaces);
    layout = own;
    workspaces.shown = name;
}

void keep_workspaces(const Layout& layout, const Workspaces& workspaces,
                     std::map<std::string, double>& kept) {
    std::erase_if(kept, [](const auto& one) { return one.first.find('/') != std::string::npos; });
    for (const auto& [arrangement, name] : kArrangements) {
        const auto left = workspaces.left.find(arrangement);
        if (left != workspaces.left.end()) keep(left->second, std::string(name), kept);
    }
    for (const auto& [name, own] : workspaces.own) keep(own, std::string(kOwn) + name, kept);
    keep(layout, "shown", kept);
}

void restore_workspaces(const std::map<std::string, double>& kept, Layout& layout,
                        Workspaces& workspaces) {
    layout = first_layout(Arrangement::design);
    for (const auto& [key, number] : kept) {
        const std::size_t slash = key.rfind('/');
        if (slash == std::string::npos) continue;
        const std::string_view name = std::string_view(key).substr(0, slash);
        const std::string_view what = std::string_view(key).substr(slash + 1);
        if (name == "shown") take(what, number, layout);
        if (name.starts_with(kOwn)) {
            take(what, number, workspaces.own[std::string(name.substr(kOwn.size()))]);
        }
        for (const auto& [arrangement, word] : kArrangements) {
            if (name == word) take(what, number, workspaces.left[arrangement]);
        }
    }
    for (auto& [arrangement, left] : workspaces.left) left.arrangement = arrangement;
    if (layout.arrangement == Arrangement::physiology) layout.maximised = Pane::physiology;
}

void open_workspace_dialog(Ui& ui, Workspaces& workspaces) {
    workspaces.typed = workspaces.shown;
    ui.dialog = kWorkspaceDialog;
}

void draw_workspace_dialog(Ui& ui, const Layout& layout, Workspaces& workspaces) {
    if (!begin_dialog(ui, kWorkspaceDialog, 420.0F)) return;
    constexpr std::size_t kLongestName = 40;
    draw_label(ui, "Name");
    if (ImGui::IsWindowAppearing()) focus_next_item();
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##workspace", "such as: large map, no stages", &workspaces.typed);
    note_item(ui.rects, "workspace:name", workspaces.typed);
    const bool replaces = workspaces.own.contains(workspaces.typed);
    const bool odd =
        workspaces.typed.size() > kLongestName || workspaces.typed.find('/') != std::string::npos;
    dim_text(ui, odd        ? "A name has no / and at most 40 letters."
                 : replaces ? "There is one of this name; it is replaced."
                            : "Panes, their sizes and what they show, in the View menu.");
    if (!draw_ends(ui, "Save", !workspaces.typed.empty() && !odd)) return;
    workspaces.own[workspaces.typed] = layout;
    workspaces.own[workspaces.typed].maximised.reset();
    workspaces.shown = workspaces.typed;
    say(ui, "Saved the workspace " + workspaces.typed + ".");
}

}  // namespace tact
