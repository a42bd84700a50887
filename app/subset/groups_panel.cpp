// The patterns in groups of alike ones: a tree, the line that cuts it, and what stands for each
// group.

#include <algorithm>
#include <cmath>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "app/subset/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/dendrogram_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

const std::vector<Vibration>& vibrations_of(const FoundGroups& found) {
    return found.request.map->request.set->vibrations;
}

bool is_of_preview(const FoundGroups& found) { return found.request.map->request.preview; }

void draw_group_count(Ui& ui, SubsetState& picking, const CutGroups& cut) {
    ImGui::AlignTextToFramePadding();
    plain_text(ui, {.id = "groups label:count", .text = "Groups"});
    if (ImGui::IsItemHovered() && is_reset_asked(ui)) {
        picking.group_count = 0;
        picking.cut.reset();
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    int count = static_cast<int>(cut.count);
    const auto most = static_cast<double>(cut.of->groups.tree.size);
    if (enter_whole_with_buttons(ui,
                                 {.id = "group count",
                                  .label = "Groups",
                                  .format = "%.9g",
                                  .rules = {{1.0, std::max(most, 1.0)}},
                                  .width_px = 96.0F * ui.theme.scale},
                                 count)) {
        picking.group_count = count;
        picking.cut.reset();
    }
    say_of_last_item(ui, {.id = "groups:count",
                          .text = std::to_string(cut.count),
                          .tip = "Into how many groups the tree is cut."});
}

void draw_cut_entry(Ui& ui, SubsetState& picking) {
    const float width = 84.0F * ui.theme.scale;
    const float label_px = ImGui::CalcTextSize("Cut at PM").x;
    flow_on(label_px + ui.theme.gap_px + width, 1.5F * ui.theme.gap_px);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Cut at PM");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    double cut = cut_height(picking);
    if (enter_number(ui,
                     {.id = "cut",
                      .label = "Cut at PM",
                      .format = "%.6g",
                      .rules = {{0.0, 1e9}},
                      .width_px = width},
                     cut)) {
        picking.cut = cut;
    }
    say_of_last_item(
        ui, {.id = "groups:cut",
             .text = significant(cut, 6),
             .tip = "Groups stay apart where the mean PM of their pairs is above this. The line in "
                    "the tree can be dragged, too."});
}

// Why one may not be kept of each group now; empty: it may.
std::string keep_obstacle(const Workspace& work, const ShownMap& shown_map,
                          const FoundGroups& found) {
    if (is_of_preview(found)) return "The groups are of a preview: wait for the exact map.";
    if (found.request.map != shown_map.transition.shown ||
        map_state(work, shown_map) != MapState::exact) {
        return "The groups are from before the last change.";
    }
    return {};
}

void draw_keep(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
               const FoundGroups& found) {
    constexpr const char* kKeep = "Keep one of each";
    flow_on(button_width(kKeep), 1.5F * ui.theme.gap_px);
    const std::string obstacle = keep_obstacle(work, shown_map, found);
    if (primary_button(
            ui, {.id = "button:keep groups",
                 .label = kKeep,
                 .tip = "Locks the most central pattern of each group, unless one of the group is "
                        "locked, and shows them as the subset: to be exported, reported, played.",
                 .why_not = obstacle,
                 .value = obstacle})) {
        keep_groups(ui, work, shown_map, picking);
    }
}

std::string summary_of(const CutGroups& cut) {
    const SetGroups& groups = cut.of->groups;
    const auto [from, below] = cuts_of(groups.tree, cut.count);
    std::string text = counted(cut.count, "group", "groups") + " of " +
                       counted(groups.grouped.size(), "pattern", "patterns") + " at a cut from " +
                       worth_text(from) +
                       (std::isfinite(below) ? " to below " + worth_text(below) + "." : " on.");
    if (std::isfinite(groups.agreement)) {
        text += " The tree keeps the order of the pairs with \u03c1 " +
                significant(groups.agreement, 2) + ".";
    }
    if (!groups.unfelt.empty()) {
        text += " " + grouped_digits(groups.unfelt.size()) + " not felt, apart.";
    }
    if (!groups.dropped.empty()) {
        text += " " + grouped_digits(groups.dropped.size()) + " excluded, apart.";
    }
    return text;
}

void draw_summary(Ui& ui, const Workspace& work, const ShownMap& shown_map, const CutGroups& cut) {
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, ui.theme.dim_text, {.id = "groups:summary", .text = summary_of(cut)});
    std::string warning;
    if (is_of_preview(*cut.of)) {
        warning = "A preview, by coarse envelopes; grouped again once the map is exact.";
    } else if (!keep_obstacle(work, shown_map, *cut.of).empty()) {
        warning = "From before the last change.";
    }
    if (!warning.empty()) {
        reading_text(ui, ui.theme.warning, {.id = "groups:warning", .text = warning});
    }
    ImGui::PopFont();
}

// Selects the whole group, its central pattern in the editor.
void select_group(Workspace& work, const FoundGroups& found, const PatternGroup& group) {
    const auto& all = vibrations_of(found);
    const auto central = place_named(work.document.set, all[group.central].name);
    if (!central) return;
    select_only(work, *central);
    for (const std::size_t row : group.members) {
        const auto place = place_named(work.document.set, all[row].name);
        if (place && place != central) work.selection.others.insert(*place);
    }
    work.selection.scroll_to_current = true;
}

bool is_selected(const Workspace& work, const FoundGroups& found, const PatternGroup& group) {
    const auto& all = work.document.set.vibrations;
    return work.selection.current < all.size() &&
           all[work.selection.current].name == vibrations_of(found)[group.central].name &&
           work.selection.others.size() + 1 == group.members.size();
}

std::string members_text(const FoundGroups& found, const PatternGroup& group) {
    constexpr std::size_t kMostNamed = 30;
    const auto& all = vibrations_of(found);
    std::string text;
    for (std::size_t k = 0; k < std::min(group.members.size(), kMostNamed); ++k) {
        text += (k == 0 ? "" : ", ") + all[group.members[k]].name;
    }
    if (group.members.size() > kMostNamed) {
        text += " and " + grouped_digits(group.members.size() - kMostNamed) + " more";
    }
    if (group.members.size() > 1) {
        text += ". Farthest apart: " + all[group.far_a].name + " and " + all[group.far_b].name +
                ", PM " + worth_text(group.farthest) + ". A click selects them.";
    }
    return text;
}

void draw_group_row(Ui& ui, Workspace& work, const CutGroups& cut, std::size_t k) {
    const FoundGroups& found = *cut.of;
    const PatternGroup& group = cut.groups[k];
    const std::string& name = vibrations_of(found)[group.central].name;
    const float s = ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (option(ui,
               {.id = "group:" + name,
                .label = "",
                .tip = members_text(found, group),
                .value = std::to_string(group.members.size())},
               is_selected(work, found, group))) {
        select_group(work, found, group);
    }
    if (ImGui::IsItemHovered()) {
        work.selection.hovered = place_named(work.document.set, name);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight();
    draw_pattern_mark(list, ui.theme, {corner.x + 8.0F * s, corner.y + 0.5F * line}, 5.0F * s,
                      group_look(ui.theme, cut, k), ui.theme.pane);
    const ImFont* font = ui.theme.fonts.regular;
    const std::string count = grouped_digits(group.members.size());
    const float count_px = text_size(font, count).x;
    draw_text(list, font, {corner.x + width - count_px, corner.y}, ui.theme.dim_text, count);
    const float begin = corner.x + 22.0F * s;
    const float room = std::max(1.0F, corner.x + width - count_px - ui.theme.gap_px - begin);
    draw_text(list, font, {begin, corner.y}, ui.theme.text, shortened(font, name, room));
}

// The largest groups first; equal ones as in the tree.
std::vector<std::size_t> by_size(const CutGroups& cut) {
    std::vector<std::size_t> order(cut.groups.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t k) { return cut.groups[k].members.size(); });
    return order;
}

void draw_group_list(Ui& ui, Workspace& work, const CutGroups& cut) {
    const std::vector<std::size_t> order = by_size(cut);
    ImGui::PushFont(ui.theme.fonts.small);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x;
    constexpr const char* kCount = "patterns";
    const float count_px = text_size(ui.theme.fonts.small, kCount).x;
    dim_text(ui, "Most central");
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, {right - count_px, corner.y},
              ui.theme.dim_text, kCount);
    ImGui::PopFont();
    ImGui::BeginChild("groups");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(order.size()));
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            draw_group_row(ui, work, cut, order[static_cast<std::size_t>(k)]);
        }
    }
    ImGui::EndChild();
}

// Objects of the tree are those rows of the map that are in it.
void draw_tree(Ui& ui, Workspace& work, SubsetState& picking, const CutGroups& cut,
               const Rect& area) {
    const SetGroups& groups = cut.of->groups;
    const auto& all = vibrations_of(*cut.of);
    std::vector<PatternLook> looks;
    std::vector<std::string> names;
    std::optional<std::size_t> lit;
    std::string hovered;
    if (work.selection.hovered_last) {
        hovered = work.document.set.vibrations[*work.selection.hovered_last].name;
    }
    for (std::size_t k = 0; k < groups.grouped.size(); ++k) {
        const std::size_t row = groups.grouped[k];
        looks.push_back(group_look(ui.theme, cut, cut.group_of[row]));
        names.push_back(all[row].name);
        if (all[row].name == hovered) lit = k;
    }
    const DendrogramPlaces places = dendrogram_places(groups.tree);
    const std::string words = counted(cut.count, "group", "groups");
    const DendrogramScene scene{.tree = groups.tree,
                                .places = places,
                                .looks = looks,
                                .names = names,
                                .title = "PM, mean of a join's pairs",
                                .words = words,
                                .cut = cut_height(picking),
                                .lit = lit,
                                .stale = false};
    const DendrogramAction action = draw_dendrogram("tree", ui.theme, area, scene);
    note_rect(ui.rects, "groups:tree", area.min, area.max, std::to_string(groups.tree.size));
    const float y = dendrogram_height_px(ui.theme, area, scene, scene.cut);
    note_rect(ui.rects, "groups:line", {area.min.x, y}, {area.max.x, y}, significant(scene.cut, 6));
    if (action.cut) picking.cut = *action.cut;
    if (!action.hovered) return;
    const std::string& name = names[*action.hovered];
    work.selection.hovered = place_named(work.document.set, name);
    if (action.clicked) {
        if (const auto place = place_named(work.document.set, name)) select_only(work, *place);
    }
    if (action.cut) return;
    const PatternGroup& group = cut.groups[cut.group_of[groups.grouped[*action.hovered]]];
    const std::vector<std::string> lines{
        name, group.members.size() == 1 ? std::string("a group of its own")
                                        : "with " + all[group.central].name + " in a group of " +
                                              grouped_digits(group.members.size())};
    draw_readout(*ImGui::GetWindowDrawList(), ui.theme, area, ImGui::GetIO().MousePos, lines);
}

void draw_no_groups(Ui& ui, const Workspace& work, const SubsetState& picking) {
    if (draw_failure(ui, "groups", picking.groups_job.failure())) return;
    const Rect area = rest_of_pane();
    if (area.empty()) return;
    const bool few = work.document.set.vibrations.size() < 2;
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
               few ? "Nothing to group" : "No groups yet",
               few ? "It takes two patterns to be alike."
                   : "Patterns are grouped once the map above is there.");
}

}  // namespace

void draw_groups_view(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    const FoundGroups* found = shown_groups(shown_map, picking);
    if (found == nullptr) return draw_no_groups(ui, work, picking);
    if (found->groups.tree.size < 2) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "Nothing to group",
                          "Fewer than two patterns are felt and not excluded.");
    }
    draw_group_count(ui, picking, cut_groups(picking));
    draw_cut_entry(ui, picking);
    draw_keep(ui, work, shown_map, picking, *found);
    const CutGroups& cut = cut_groups(picking);
    draw_summary(ui, work, shown_map, cut);
    const Rect area = rest_or_lines(6.0F);
    const float s = ui.theme.scale;
    const float list_px = ImGui::GetTextLineHeightWithSpacing() *
                          static_cast<float>(std::min<std::size_t>(cut.groups.size(), 40) + 1);
    const WordsAndPicture parts = words_and_picture(
        area, {180.0F * s, 340.0F * s, list_px}, {160.0F * s, 120.0F * s}, 1.5F * ui.theme.gap_px);
    ImGui::SetCursorScreenPos(parts.words.min);
    ImGui::BeginChild("group list", parts.words.size());
    draw_group_list(ui, work, cut);
    ImGui::EndChild();
    if (!parts.picture.empty()) draw_tree(ui, work, picking, cut, parts.picture);
}

}  // namespace tact
