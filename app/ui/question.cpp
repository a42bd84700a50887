#include "app/ui/question.h"

#include <imgui_internal.h>

#include <utility>

#include "app/ui/dialog.h"
#include "app/ui/widgets.h"
#include "app/window/app.h"

namespace tact {

namespace {

bool is_struck(ImGuiKey which) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(which), false); }

void move_mark(Question& question) {
    const std::size_t count = question.answers.size();
    const bool tab = is_struck(ImGuiKey_Tab);
    const bool back = tab && ImGui::GetIO().KeyShift;
    if (is_struck(ImGuiKey_RightArrow) || (tab && !back)) {
        question.marked = (question.marked + 1) % count;
    }
    if (is_struck(ImGuiKey_LeftArrow) || back) {
        question.marked = (question.marked + count - 1) % count;
    }
}

// The buttons; the one that was chosen.
std::optional<std::size_t> draw_answers(App& app, const Question& question) {
    std::optional<std::size_t> chosen;
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);  // Enter is for the marked one alone
    for (std::size_t k = 0; k < question.answers.size(); ++k) {
        const std::string& label = question.answers[k].label;
        const bool is_marked = k == question.marked;
        if (k > 0) ImGui::SameLine();
        const ImU32 lit = (app.theme.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 110);
        ImGui::PushStyleColor(ImGuiCol_Button, is_marked ? lit : dialog_field(app.theme));
        if (ImGui::Button(label.c_str())) chosen = k;
        ImGui::PopStyleColor();
        note_item(app.rects, "answer:" + label, is_marked ? "marked" : "");
    }
    ImGui::PopItemFlag();
    return chosen;
}

std::optional<std::size_t> chosen_by_key(const App& app, const Question& question) {
    if (is_struck(ImGuiKey_Enter) || is_struck(ImGuiKey_KeyPadEnter)) return question.marked;
    if (is_struck(ImGuiKey_Escape) && !app.escape_taken) return question.answers.size() - 1;
    return {};
}

}  // namespace

void ask(App& app, Question question) {
    app.dialog = Dialog::none;
    app.chooser.is_open = false;
    app.question = std::move(question);
}

void tell(App& app, const std::string& title, const std::string& text) {
    ask(app, {.title = title, .text = text, .answers = {{"Go on"}}});
}

void draw_question(App& app) {
    if (!app.question) return;
    Question& question = *app.question;
    if (!begin_dialog(app, (question.title + "###question").c_str())) return;
    ImGui::TextWrapped("%s", question.text.c_str());
    note_item(app.rects, "question", question.text);
    ImGui::Spacing();
    // The key that asked has not answered yet.
    std::optional<std::size_t> chosen;
    if (!ImGui::IsWindowAppearing()) {
        move_mark(question);
        chosen = chosen_by_key(app, question);
    }
    if (const auto pressed = draw_answers(app, question)) chosen = pressed;
    if (chosen) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!chosen) return;
    // An answer may ask anew.
    const Question answered = *std::exchange(app.question, std::nullopt);
    if (const auto& run = answered.answers[*chosen].run) run();
}

}  // namespace tact
