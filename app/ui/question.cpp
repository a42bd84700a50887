#include "app/ui/question.h"

#include <imgui_internal.h>

#include <utility>

#include "app/ui/dialog.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/shown_text.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

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
        const bool pressed =
            is_marked ? primary_button(ui, label.c_str()) : ImGui::Button(label.c_str());
        if (pressed) chosen = k;
        note_item(ui.rects, "answer:" + label, is_marked ? "marked" : "");
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
    ui.dialog = Dialog::none;
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
