#include "app/patterns/patterns.h"

#include <imgui_internal.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/patterns/parts.h"
#include "app/pictures/pictures.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

void keep_on_screen(const Theme& theme) {
    const float below = ImGui::GetWindowPos().y + ImGui::GetWindowSize().y + 0.5F * theme.gap_px -
                        ImGui::GetIO().DisplaySize.y;
    if (below <= 0.0F) return;
    ImGui::SetWindowPos({ImGui::GetWindowPos().x, std::max(0.0F, ImGui::GetWindowPos().y - below)});
}

namespace {

// True if it is chosen, by mouse or keyboard.
bool look_item(Ui& ui, const std::string& text, const PatternLook& look, bool is_now) {
    constexpr const char* kRoom = "     ";  // width of a sign, as in draw_menu_row
    const bool chosen = ImGui::MenuItemEx(text.c_str(), kRoom, nullptr, is_now);
    note_item(ui.rects, "row menu:" + text, is_now ? "chosen" : "");
    const float radius = 5.5F * ui.theme.scale;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 middle{low.x + 0.5F * ImGui::GetStyle().ItemSpacing.x + radius,
                        0.5F * (low.y + ImGui::GetItemRectMax().y)};
    draw_pattern_mark(*ImGui::GetWindowDrawList(), ui.theme, middle, radius, look,
                      ImGui::GetColorU32(ImGuiCol_PopupBg));
    return chosen;
}

void draw_look_menu(Ui& ui, Workspace& work, std::size_t index) {
    const bool is_open = ImGui::BeginMenu("Colour and mark");
    note_item(ui.rects, "row menu:Colour and mark");
    if (!is_open) return;
    const Vibration& vibration = work.document.set.vibrations[index];
    const PatternLook now = look_of(ui, work, index);
    const auto choose = [&](std::string colour, bool ring) {
        ui.waiting.emplace_back([&ui, &work, colour = std::move(colour), ring] {
            change_look(ui, work, colour, ring);
        });
    };
    const auto place = palette_place(vibration.colour);
    for (std::size_t k = 0; k < kPatternColourCount; ++k) {
        const PatternLook look{ui.theme.pattern[k], vibration.ring};
        const PatternColour& colour = kPatternColours[k];
        if (look_item(ui, colour.name, look, place == k)) choose(colour.hex, vibration.ring);
    }
    draw_divider(ui.theme);
    for (const bool ring : {false, true}) {
        if (look_item(ui, ring ? "Ring" : "Disc", {now.colour, ring}, vibration.ring == ring)) {
            choose(vibration.colour, ring);
        }
    }
    ImGui::EndMenu();
}

// Opens above the row if the menu would end below the window.
void keep_off_row(const Theme& theme, const Rect& row) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 size = ImGui::GetWindowSize();
    ImVec2 at = ImGui::GetWindowPos();
    at.x = std::max(0.0F, std::min(at.x, screen.x - size.x - theme.gap_px));
    if (at.y + size.y > screen.y && size.y <= row.min.y) at.y = row.min.y - size.y;
    ImGui::SetWindowPos(at);
    keep_on_screen(theme);
}

}  // namespace

PatternAction draw_pattern_menu(Ui& ui, Workspace& work, std::size_t index, const char* play_key) {
    if (index >= work.document.set.vibrations.size()) return PatternAction::none;
    if (index != work.selection.current && !work.selection.others.contains(index)) {
        select_only(work, index);
    }
    const Vibration& vibration = work.document.set.vibrations[index];
    PatternAction action = PatternAction::none;
    const auto row = [&ui](const char* words, const char* keys, std::optional<Icon> icon,
                           bool enabled = true) {
        const bool pressed = draw_menu_row(
            ui.theme, {.words = words, .keys = keys, .enabled = enabled, .icon = icon});
        note_item(ui.rects, std::string("row menu:") + words);
        return pressed;
    };
    // `why_not`: the reason why it is disabled.
    const auto asks = [&](const char* words, const char* keys, PatternAction what,
                          const char* why_not = nullptr, std::optional<Icon> icon = {}) {
        if (row(words, keys, icon, why_not == nullptr)) action = what;
        if (why_not != nullptr) draw_tooltip(ui, why_not);
    };
    // Runs after all rows are drawn, as it may remove some.
    const auto does = [&](const char* words, const char* keys, std::function<void()> act,
                          std::optional<Icon> icon = {}) {
        if (row(words, keys, icon)) ui.waiting.push_back(std::move(act));
    };
    const std::size_t count = work.document.set.vibrations.size();
    const bool has_numbers = std::holds_alternative<Pattern>(vibration.source);
    asks("Play", play_key, PatternAction::play, nullptr, Icon::play);
    asks("Rename", "F2", PatternAction::rename);
    draw_divider(ui.theme);
    does(
        vibration.locked ? "Unlock" : "Lock", "Ctrl+L", [&] { toggle_locked(ui, work); },
        Icon::locked);
    does(
        vibration.dropped ? "Include" : "Exclude", "Ctrl+Shift+L",
        [&] { toggle_dropped(ui, work); }, Icon::dropped);
    draw_divider(ui.theme);
    does("Duplicate", "Ctrl+D", [&] { duplicate_selected(ui, work); });
    does("Copy", "Ctrl+C", [&] { copy_selected(ui, work); });
    draw_divider(ui.theme);
    asks("Find similar", "", PatternAction::similar,
         count < 2 ? "there is no other pattern" : nullptr);
    const bool has_layers = std::holds_alternative<LayeredPattern>(vibration.source);
    const char* no_numbers = has_numbers  ? nullptr
                             : has_layers ? "needs a pattern without layers"
                                          : "needs a pattern, not a recording";
    asks("Vary", "V", PatternAction::vary,
         no_numbers != nullptr ? no_numbers
         : vibration.locked    ? "is locked"
         : count < 3           ? "needs three patterns: a map"
                               : nullptr);
    asks("Steps to...", "", PatternAction::steps, no_numbers);
    asks("Transform...", "Ctrl+T", PatternAction::transform,
         vibration.locked ? "is locked" : nullptr);
    draw_divider(ui.theme);
    draw_look_menu(ui, work, index);
    draw_divider(ui.theme);
    does("Delete", "Del", [&] { remove_selected(ui, work); });
    return action;
}

PatternAction draw_row_menu(Ui& ui, Workspace& work, std::size_t index, const char* play_key) {
    const Rect row{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    const float gap = ui.theme.gap_px;  // rows of a list are lower than those of a menu
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, 0.75F * gap));
    ImGui::SetNextWindowPos({ImGui::GetIO().MousePos.x, row.max.y}, ImGuiCond_Appearing);
    PatternAction action = PatternAction::none;
    if (ImGui::BeginPopupContextItem("row menu")) {
        keep_off_row(ui.theme, row);
        action = draw_pattern_menu(ui, work, index, play_key);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
    return action;
}

}  // namespace tact
