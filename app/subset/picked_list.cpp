#include "app/subset/subset.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/play/play.h"
#include "app/subset/parts.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

bool has_picture(const Ui& ui, float width_px) { return width_px >= 360.0F * ui.theme.scale; }

}  // namespace

float member_row_px(const Ui& ui, float width_px) {
    const float words = ImGui::GetTextLineHeight();
    const float row = has_picture(ui, width_px) ? std::max(words, 26.0F * ui.theme.scale) : words;
    return row + ImGui::GetStyle().ItemSpacing.y;
}

PatternAction draw_member(Ui& ui, Workspace& work, const std::string& name, std::size_t number) {
    const auto place = place_named(work.document.set, name);
    if (!place) return PatternAction::none;
    const Vibration& vibration = work.document.set.vibrations[*place];
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float s = ui.theme.scale;
    const float width = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float height = member_row_px(ui, width) - gap;
    const bool has_key = number <= kPlayKeys;
    const std::string key = has_key ? std::to_string(number) : std::string();
    ImGui::PushID(static_cast<int>(number));
    if (option(ui,
               {.id = "member:" + name,
                .label = "",
                .tip = (has_key ? "Key " + key + " plays it. " : std::string()) + kHoldHelp,
                .value = vibration.locked ? "locked" : ""},
               work.selection.current == *place, 0, {0.0F, height})) {
        select_only(work, *place);
    }
    if (ImGui::IsItemActive()) note_pressed(work, vibration);
    if (ImGui::IsItemHovered()) work.selection.hovered = place;
    // What only a member has is its number, which is the key that plays it, as far as keys go.
    const PatternAction action = draw_row_menu(ui, work, *place, key.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const PatternLook look = look_of(ui, work, *place);
    const float middle = corner.y + 0.5F * height;
    const float text_y = middle - 0.5F * ImGui::GetTextLineHeight();
    const ImFont* font = has_key ? ui.theme.fonts.regular : ui.theme.fonts.small;
    const std::string shown = std::to_string(number);
    draw_text(list, font, {corner.x + 2.0F * s, middle - 0.5F * text_size(font, shown).y},
              ui.theme.dim_text, shown);
    draw_pattern_mark(list, ui.theme, {corner.x + 23.0F * s, middle}, 5.0F * s, look,
                      ui.theme.pane);
    float right = corner.x + width;
    if (has_picture(ui, width)) {
        const Rect picture{{corner.x + 0.6F * width, corner.y + s},
                           {right - s, corner.y + height - s}};
        draw_thumbnail(ui, work, picture, vibration, look.colour, shown_reach_g(work),
                       work.cache.axis_s);
        right = picture.min.x - ui.theme.gap_px;
    }
    draw_state_signs(ui, vibration, {right, middle});
    const float begin = corner.x + 36.0F * s;
    float room = right - begin - state_signs_px(ui.theme, vibration);
    if (work.selection.unfelt.contains(name)) {
        constexpr const char* kUnfelt = "not felt";
        const ImFont* small = ui.theme.fonts.small;
        const ImVec2 size = text_size(small, kUnfelt);
        const ImVec2 at{begin + std::max(0.0F, room - size.x), middle - 0.5F * size.y};
        draw_text(list, small, at, ui.theme.warning, kUnfelt);
        note_rect(ui.rects, "member not felt:" + name, at, at + size);
        room -= size.x + ui.theme.gap_px;
    }
    draw_text(list, ui.theme.fonts.regular, {begin, text_y}, ui.theme.text,
              shortened(ui.theme.fonts.regular, name, std::max(0.0F, room)));
    ImGui::PopID();
    return action;
}

void play_picked(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                 PlayState& play, const SubsetState& picking, std::size_t number) {
    const Subset* subset = shown_subset(shown_map, picking);
    if (subset == nullptr) {
        return say(ui, "Nothing is picked yet: 1 to 9 play what View > Panes > Subset picks.");
    }
    const std::size_t count = subset->members.size();
    if (number > count) return say(ui, "Only " + std::to_string(count) + " are picked.");
    const auto& mapped = shown_map.transition.shown->request.set->vibrations;
    const std::string& name = mapped[subset->members[number - 1]].name;
    const auto place = place_named(work.document.set, name);
    if (!place) return say(ui, name + " is no longer in the set.");
    play_once(ui, work, timeline, play, *place);
    if (is_sounding(play)) say(ui, "Plays " + std::to_string(number) + ", " + name + ".");
}

MapMarks subset_marks(const Theme& theme, const Layout& layout, const ShownMap& shown_map,
                      SubsetState& picking) {
    MapMarks marks;
    if (layout.bench != BenchTab::subset || !shown_map.transition.shown) return marks;
    if (picking.view == SubsetView::groups) {
        if (shown_groups(shown_map, picking) == nullptr) return marks;
        const CutGroups& cut = cut_groups(picking);
        for (const std::size_t group : cut.group_of) {
            marks.looks.push_back(group_look(theme, cut, group));
        }
        return marks;
    }
    const bool confusable = picking.view == SubsetView::confusable;
    const Subset* subset = shown_subset(shown_map, picking);
    if (subset && (!confusable || picking.too_close == TooClose::picked)) {
        marks.chosen = subset->members;
    } else if (const auto opened = opened_rows(shown_map, picking); opened && confusable) {
        marks.chosen = {opened->first, opened->second};
    }
    if (confusable) {
        for (const ConfusablePair& pair : too_close_pairs(shown_map, picking).pairs) {
            marks.links.push_back({pair.a, pair.b});
        }
    }
    const Stability* stability = shown_stability(picking);
    if (picking.view == SubsetView::stability && stability &&
        picking.pick->request.map == shown_map.transition.shown) {
        marks.spread = stability->moves;
    }
    return marks;
}

std::set<std::string> too_close_names(const Layout& layout, const SubsetState& picking) {
    if (layout.bench != BenchTab::subset || picking.view != SubsetView::confusable) return {};
    if (!picking.pairs.of) return {};
    const auto& all = picking.pairs.of->request.set->vibrations;
    std::set<std::string> names;
    for (const ConfusablePair& pair : picking.pairs.pairs) {
        names.insert(all[pair.a].name);
        names.insert(all[pair.b].name);
    }
    return names;
}

}  // namespace tact
