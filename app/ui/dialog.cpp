#include "app/ui/dialog.h"

#include <algorithm>

#include "app/ui/number_field.h"
#include "app/ui/widgets.h"

namespace tact {

bool begin_dialog(const Ui& ui, const char* title, float width_px) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(screen * 0.5F, ImGuiCond_Always, {0.5F, 0.5F});
    const float width = std::min(width_px * ui.theme.scale, screen.x * 0.9F);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y * 0.9F});
    ImGui::SetNextWindowSize({width, 0.0F});
    return ImGui::BeginPopupModal(
        title, nullptr,
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
}

bool is_popup_open() {
    return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

ImU32 dialog_field(const Theme& theme) { return theme.is_dark ? theme.pane : theme.field; }

void end_dialog(Ui& ui) {
    ImGui::Spacing();
    const bool typing = is_number_typed(ui);  // whose keys these are then
    const bool escape =
        ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) && !ui.escape_taken && !typing;
    const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) && !typing &&
                       !ui.rects.tab_order.is_on_button;
    ImGui::PushStyleColor(ImGuiCol_Button, dialog_field(ui.theme));
    if (ImGui::Button("Close") || escape || enter) {
        ui.dialog = Dialog::none;
        ImGui::CloseCurrentPopup();
    }
    ImGui::PopStyleColor();
    note_item(ui.rects, "button:close");
    ImGui::EndPopup();
}

bool draw_ends(Ui& ui, const char* action, bool enabled) {
    ImGui::Spacing();
    const auto pressed = [&](ImGuiKey which) {
        return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which), false) && !is_number_typed(ui);
    };
    const bool enter = (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) &&
                       !ui.rects.tab_order.is_on_button;
    ImGui::PushStyleColor(ImGuiCol_Button, dialog_field(ui.theme));
    ImGui::BeginDisabled(!enabled);
    const bool go = ImGui::Button(action) || (enabled && enter);
    ImGui::EndDisabled();
    note_item(ui.rects, "button:choose");
    ImGui::SameLine();
    const bool escape = pressed(ImGuiKey_Escape) && !ui.escape_taken;
    const bool leave = ImGui::Button("Cancel") || escape;
    note_item(ui.rects, "button:cancel");
    ImGui::PopStyleColor();
    if (go || leave) {
        ui.dialog = Dialog::none;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    return go;
}

}  // namespace tact
