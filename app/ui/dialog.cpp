#include "app/ui/dialog.h"

#include <imgui_internal.h>

#include <algorithm>

#include "app/ui/number_field.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

bool begin_dialog(const Ui& ui, const char* title, float width_px) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(screen * 0.5F, ImGuiCond_Always, {0.5F, 0.5F});
    const float width = std::min(width_px * ui.theme.scale, screen.x * 0.9F);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y * 0.9F});
    ImGui::SetNextWindowSize({width, 0.0F});
    ImFont* const before = push_dialog_head(ui.theme);
    const bool is_open = ImGui::BeginPopupModal(
        title, nullptr,
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
    pop_dialog_head(before);
    return is_open;
}

ImFont* push_dialog_head(const Theme& theme) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.hairline_px);
    // The title begins where the content does.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().WindowPadding.x,
                                                     1.5F * ImGui::GetStyle().FramePadding.y});
    // Not PushFont: what it pushes belongs to the window that is current, which then is another.
    ImFont* before = ImGui::GetFont();
    if (theme.fonts.title != nullptr) ImGui::SetCurrentFont(theme.fonts.title);
    return before;
}

void pop_dialog_head(ImFont* before) {
    ImGui::SetCurrentFont(before);
    ImGui::PopStyleVar(2);
}

void draw_shadows(const Theme& theme) {
    constexpr int kRings = 14;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        const bool is_over = (window->Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip |
                                               ImGuiWindowFlags_Modal)) != 0;
        if (!is_over || !window->Active || window->Hidden) continue;
        ImDrawList& list = *window->DrawList;
        list.PushClipRectFullScreen();
        const ImVec2 low{0.0F, 4.0F * theme.scale};
        for (int ring = 1; ring <= kRings; ++ring) {
            const float out = (static_cast<float>(ring) - 0.5F) * theme.scale;
            const float left = 1.0F - static_cast<float>(ring) / kRings;
            list.AddRect(window->Pos + low * (1.0F - left) - ImVec2{out, out},
                         window->Pos + window->Size + low * (1.0F - left) + ImVec2{out, out},
                         faded(IM_COL32_BLACK, (theme.is_dark ? 0.28F : 0.10F) * left * left),
                         window->WindowRounding + out, 0, theme.scale);
        }
        list.PopClipRect();
    }
}

bool is_popup_open() {
    return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void end_dialog(Ui& ui) {
    ImGui::Spacing();
    const bool typing = is_number_typed(ui);  // whose keys these are then
    const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape) && !ui.escape_taken && !typing;
    // Enter in a field of text has been taken by that.
    const bool in_text = ImGui::GetCurrentContext()->ActiveIdPreviousFrame != 0;
    const bool enter = ImGui::IsKeyPressed(ImGuiKey_Enter) && !typing && !in_text &&
                       !ui.rects.tab_order.is_on_button;
    if (ImGui::Button("Close") || escape || enter) {
        ui.dialog = Dialog::none;
        ImGui::CloseCurrentPopup();
    }
    note_item(ui.rects, "button:close");
    ImGui::EndPopup();
}

bool draw_ends(Ui& ui, const char* action, bool enabled) {
    ImGui::Spacing();
    const auto pressed = [&](ImGuiKey which) {
        return ImGui::IsKeyPressed(which, false) && !is_number_typed(ui);
    };
    const bool enter = (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeypadEnter)) &&
                       !ui.rects.tab_order.is_on_button;
    ImGui::BeginDisabled(!enabled);
    const bool go = primary_button(ui.theme, action) || (enabled && enter);
    ImGui::EndDisabled();
    note_item(ui.rects, "button:choose");
    ImGui::SameLine();
    const bool escape = pressed(ImGuiKey_Escape) && !ui.escape_taken;
    const bool leave = ImGui::Button("Cancel") || escape;
    note_item(ui.rects, "button:cancel");
    if (go || leave) {
        ui.dialog = Dialog::none;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    return go;
}

}  // namespace tact
