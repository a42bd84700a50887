#include "app/ui/ui.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "app/ui/widgets.h"
#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kMostHeight = 0.9F;  // share of the window
constexpr float kEdgePx = 2.0F;      // for the frames of items at the edges of the scrolling part

// Heights of the dialog when it was drawn last; ImGui keeps them with the window.
constexpr ImGuiID kBody = 1;    // all of the scrolling part
constexpr ImGuiID kShown = 2;   // the visible part of that
constexpr ImGuiID kAround = 3;  // its title, its foot and the spacing

float kept_px(ImGuiWindow* dialog, ImGuiID what) {
    return dialog == nullptr ? 0.0F : dialog->StateStorage.GetFloat(what);
}

// The height of everything but the scrolling part; an estimate until it is known.
float room_px(float around_px) {
    const float line = ImGui::GetFrameHeightWithSpacing();
    const float room = kMostHeight * ImGui::GetIO().DisplaySize.y;
    return std::max(room - (around_px > 0.0F ? around_px : 5.0F * line), 2.0F * line);
}

void begin_body(const Ui& ui, float height_px) {
    const ImVec2 pad{ImGui::GetStyle().WindowPadding.x, kEdgePx * ui.theme.scale};
    ImGui::SetCursorPos({0.0F, ImGui::GetCursorPosY() - pad.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
    ImGui::BeginChild("body", {ImGui::GetWindowWidth(), height_px}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
}

}  // namespace

float dialog_room_px() {
    return room_px(kept_px(ImGui::GetCurrentWindowRead()->RootWindow, kAround));
}

bool begin_dialog(const Ui& ui, const char* title, float width_px, DialogSide side) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGuiWindow* const before = ImGui::FindWindowByName(title);
    const float around = kept_px(before, kAround);
    const float content = kept_px(before, kBody);
    const float room = room_px(around);
    const float body = content > 0.0F ? std::min(content, room) : room;
    if (side == DialogSide::middle) {
        ImGui::SetNextWindowPos(screen * 0.5F, ImGuiCond_Always, {0.5F, 0.5F});
    } else {
        ImGui::SetNextWindowPos({screen.x - ui.theme.padding_px, 0.5F * screen.y}, ImGuiCond_Always,
                                {1.0F, 0.5F});
    }
    const float width = std::min(width_px * ui.theme.scale, screen.x * 0.9F);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y * kMostHeight});
    // ImGui's own fit would be that of the frame before the last one.
    ImGui::SetNextWindowSize({width, around > 0.0F ? around + body : 0.0F});
    ImFont* const font = push_dialog_head(ui.theme);
    const bool is_open = ImGui::BeginPopupModal(
        title, nullptr,
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    pop_dialog_head(font);
    if (is_open) begin_body(ui, body);
    return is_open;
}

bool begin_dialog(const Ui& ui, const Dialog& dialog, float width_px, DialogSide side) {
    return ui.dialog == dialog && begin_dialog(ui, dialog.title, width_px, side);
}

void begin_foot(const Ui& ui) {
    const ImGuiWindow& body = *ImGui::GetCurrentWindowRead();
    const float pad = kEdgePx * ui.theme.scale;
    ImGuiWindow& dialog = *body.ParentWindow;
    const float content = body.DC.CursorMaxPos.y - body.DC.CursorStartPos.y + 2.0F * pad;
    const float shown = body.Size.y;
    dialog.StateStorage.SetFloat(kBody, content);
    dialog.StateStorage.SetFloat(kShown, shown);
    const float widest = dialog.DC.CursorMaxPos.x;
    ImGui::EndChild();
    dialog.DC.CursorMaxPos.x = widest;  // it spans the dialog, with nothing beside it
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - pad);
    if (content <= shown + 1.0F) return;
    // There is more below. The line takes no room, which would change the visible part.
    draw_level_line(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos().y, dialog.Pos.x,
                    dialog.Pos.x + dialog.Size.x, whole_px(ui.theme.hairline_px),
                    ImGui::GetColorU32(ImGuiCol_Separator));
}

void end_foot() {
    ImGuiWindow& dialog = *ImGui::GetCurrentWindow();
    // A field that takes the keyboard may have scrolled it while it was too low.
    const float whole_px = dialog.DC.CursorMaxPos.y - dialog.Pos.y + dialog.Scroll.y +
                           ImGui::GetStyle().WindowPadding.y;
    dialog.StateStorage.SetFloat(kAround, whole_px - kept_px(&dialog, kShown));
    ImGui::EndPopup();
}

void give_way(Ui& ui) {
    ui.dialog = kNoDialog;
    ImGui::CloseCurrentPopup();
    begin_foot(ui);
    end_foot();
}

void press_focused(const Ui& ui) {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    if (!ui.keyboard_mode || !ui.rects.tab_order.is_on_button) return;
    imgui.NavNextActivateId = imgui.NavId;
    imgui.NavNextActivateFlags = ImGuiActivateFlags_None;
}

ImFont* push_dialog_head(const Theme& theme) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.hairline_px);
    // The title begins at the left edge of the content.
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().WindowPadding.x,
                                                     1.5F * ImGui::GetStyle().FramePadding.y});
    // Not PushFont, which would change the current window, not the new one.
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
    begin_foot(ui);
    ImGui::Spacing();
    const bool typing = is_number_typed(ui);  // which then gets these keys
    const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape) && !ui.escape_taken && !typing;
    // A text field has already taken Enter.
    const bool in_text = ImGui::GetCurrentContext()->ActiveIdPreviousFrame != 0;
    const bool enter = ImGui::IsKeyPressed(ImGuiKey_Enter) && !typing && !in_text &&
                       !ui.rects.tab_order.is_on_button;
    if (button(ui, {.id = "button:close", .label = "Close"}) || escape || enter) {
        ui.dialog = kNoDialog;
        ImGui::CloseCurrentPopup();
    }
    end_foot();
}

bool draw_ends(Ui& ui, const char* action, bool enabled) {
    begin_foot(ui);
    ImGui::Spacing();
    const auto pressed = [&](ImGuiKey which) {
        return ImGui::IsKeyPressed(which, false) && !is_number_typed(ui);
    };
    const bool enter = (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeypadEnter)) &&
                       !ui.rects.tab_order.is_on_button;
    const Item choose{.id = "button:choose", .label = action, .enabled = enabled, .value = ""};
    const bool go = primary_button(ui, choose) || (enabled && enter);
    ImGui::SameLine();
    const bool escape = pressed(ImGuiKey_Escape) && !ui.escape_taken;
    const bool leave = button(ui, {.id = "button:cancel", .label = "Cancel"}) || escape;
    if (go || leave) {
        ui.dialog = kNoDialog;
        ImGui::CloseCurrentPopup();
    }
    end_foot();
    return go;
}

namespace {

bool is_struck(ImGuiKey which) { return ImGui::IsKeyPressed(which, false); }

void move_mark(const TabOrder& order, Question& question) {
    const std::size_t count = question.answers.size();
    if (is_struck(ImGuiKey_RightArrow) || order.step > 0) {
        question.marked = (question.marked + 1) % count;
    }
    if (is_struck(ImGuiKey_LeftArrow) || order.step < 0) {
        question.marked = (question.marked + count - 1) % count;
    }
}

// The buttons; returns the chosen one.
std::optional<std::size_t> draw_answers(Ui& ui, const Question& question) {
    std::optional<std::size_t> chosen;
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);  // Enter is only for the marked one
    for (std::size_t k = 0; k < question.answers.size(); ++k) {
        const std::string& label = question.answers[k].label;
        const bool is_marked = k == question.marked;
        if (k > 0) ImGui::SameLine();
        const Item item{
            .id = "answer:" + label, .label = label, .value = is_marked ? "marked" : ""};
        if (is_marked ? primary_button(ui, item) : button(ui, item)) chosen = k;
    }
    ImGui::PopItemFlag();
    return chosen;
}

std::optional<std::size_t> chosen_by_key(const Ui& ui, const Question& question) {
    if (is_struck(ImGuiKey_Enter) || is_struck(ImGuiKey_KeypadEnter)) return question.marked;
    if (is_struck(ImGuiKey_Escape) && !ui.escape_taken) return question.answers.size() - 1;
    return {};
}

}  // namespace

void ask(Ui& ui, Question question) {
    ui.dialog = kNoDialog;
    ui.chooser.is_open = false;
    ui.question = std::move(question);
}

void tell(Ui& ui, const std::string& title, const std::string& text) {
    ask(ui, {.title = title, .text = text, .answers = {{"Go on"}}});
}

void draw_question(Ui& ui) {
    if (!ui.question) return;
    Question& question = *ui.question;
    if (!begin_dialog(ui, (question.title + "###question").c_str())) return;
    const std::string text = shown_lines(question.text);
    ImGui::TextWrapped("%s", text.c_str());
    note_item(ui.rects, "question", question.text);
    begin_foot(ui);
    ImGui::Spacing();
    // The key that opened the question must not answer it.
    std::optional<std::size_t> chosen;
    if (!ImGui::IsWindowAppearing()) {
        move_mark(ui.rects.tab_order, question);
        chosen = chosen_by_key(ui, question);
    }
    if (const auto pressed = draw_answers(ui, question)) chosen = pressed;
    if (chosen) ImGui::CloseCurrentPopup();
    end_foot();
    if (!chosen) return;
    // An answer may ask the next question.
    const Question answered = *std::exchange(ui.question, std::nullopt);
    if (const auto& run = answered.answers[*chosen].run) run();
}

}  // namespace tact
