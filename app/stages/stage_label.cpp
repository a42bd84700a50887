#include "app/stages/stage_label.h"

#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area) {
    const Theme& theme = ui.theme;
    const StageText& text = text_of(stage);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushID(text.key);
    ImGui::PushFont(theme.fonts.small);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushTextWrapPos(area.max.x - ImGui::GetWindowPos().x);
    const float icon = line + 8.0F * theme.scale;
    // Without room for both, the name is shown before the quantity.
    const float beside = area.width() - icon;
    const bool has_icon =
        !ui.as_picture && text_size(theme.fonts.small, text.short_name).x <= beside;
    const float room = has_icon || ui.as_picture ? beside : area.width();
    const bool wraps = area.height() >= 2.0F * line;
    const bool fits = text_size(theme.fonts.small, text.name).x <= room;
    const std::string name =
        wraps || fits ? text.name : shortened(theme.fonts.small, text.short_name, room);
    const ImVec2 size = ImGui::CalcTextSize(name.c_str(), nullptr, false, room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool pressed = ImGui::InvisibleButton("open", size);
    const bool over = !ui.as_picture && (ImGui::IsItemHovered() || ImGui::IsItemFocused());
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    list.AddText(nullptr, 0.0F, area.min, over ? theme.accent : theme.text, name.c_str(), nullptr,
                 room);
    draw_tooltip(ui, "Open this stage large");
    note_item(ui.rects, std::string("label:") + text.key);
    if (pressed) physiology.view.open = stage;
    ImGui::PopTextWrapPos();
    ImGui::PopFont();

    const float below = area.min.y + size.y;
    if (!has_icon) {
        ImGui::PopID();
        return below;
    }
    const ImVec2 centre{area.max.x - icon * 0.6F, area.min.y + line * 0.5F};
    ImGui::SetCursorScreenPos({centre.x - icon * 0.5F, centre.y - icon * 0.5F});
    if (ImGui::InvisibleButton("i", {icon, icon})) {
        const bool open = physiology.view.explained == stage;
        physiology.view.explained = open ? std::nullopt : std::optional(stage);
    }
    draw_info_mark(ui, centre, ImGui::IsItemHovered() || ImGui::IsItemFocused());
    note_item(ui.rects, std::string("explain:") + text.key);
    draw_tooltip(ui, "What happens here?");
    ImGui::PopID();
    return below;
}

void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text) {
    const float top = label.max.y - text_size(ui.theme.fonts.small, text).y;
    if (text.empty() || top < label.min.y) return;
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, {label.min.x, top},
              ui.theme.dim_text, text);
    note_rect(ui.rects, std::string("reach:") + text_of(stage).key, {label.min.x, top}, label.max,
              text);
}

}  // namespace tact
