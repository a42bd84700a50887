#include "app/lesson/question_editor.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/lesson/lesson_edit.h"
#include "app/lesson/step_editor.h"
#include "app/map/pair.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

constexpr std::array<const char*, kQuestionKinds.size()> kKindWords{
    "Choose from options", "Which receptors fire", "Which pair is closest",
    "Which pair is farthest", "Place the pattern in the map"};

bool is_of_pairs(const LessonQuestion& question) {
    return question.kind == QuestionKind::closest || question.kind == QuestionKind::farthest;
}

std::string joined_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (std::size_t k = 0; k < lines.size(); ++k) text += (k == 0 ? "" : "\n") + lines[k];
    return text;
}

std::vector<std::string> lines_of(const std::string& text) {
    if (text.empty()) return {};
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n') {
            lines.emplace_back();
        } else {
            lines.back() += c;
        }
    }
    if (lines.size() > limits::kMaxOptions) lines.resize(limits::kMaxOptions);
    return lines;
}

// The kind of question, or none.
bool draw_kind(Ui& ui, std::optional<LessonQuestion>& question) {
    const auto chosen = [&] { return static_cast<std::size_t>(question->kind); };
    bool changed = false;
    ImGui::SetNextItemWidth(-1.0F);
    const bool open = ImGui::BeginCombo("##kind", question ? kKindWords[chosen()] : "No question");
    note_item(ui.rects, "lesson edit:kind", question ? kQuestionKinds[chosen()] : "none");
    if (!open) return false;
    if (ImGui::Selectable("No question", !question) && question) {
        question.reset();
        changed = true;
    }
    note_item(ui.rects, "lesson edit:kind:none");
    for (std::size_t k = 0; k < kKindWords.size(); ++k) {
        const bool is_this = question && chosen() == k;
        if (ImGui::Selectable(kKindWords[k], is_this) && !is_this) {
            if (!question) question.emplace();
            question->kind = static_cast<QuestionKind>(k);
            changed = true;
        }
        note_item(ui.rects, std::string("lesson edit:kind:") + kQuestionKinds[k]);
    }
    ImGui::EndCombo();
    return changed;
}

// Lines of options, with a tick at the right one.
bool edit_options(Ui& ui, TextBox& box, LessonQuestion& question) {
    std::string text = joined_lines(question.options);
    bool changed = edit_text(ui, box, "##options", "Options, one a line", 3, text);
    if (changed) question.options = lines_of(text);
    if (!question.options.empty()) {
        question.answer = std::min(question.answer, question.options.size() - 1);
    }
    for (std::size_t k = 0; k < question.options.size(); ++k) {
        const std::string label = "Right: " + question.options[k];
        ImGui::PushID(static_cast<int>(k));
        if (draw_radio(ui, label.c_str(), question.answer == k) && question.answer != k) {
            question.answer = k;
            changed = true;
        }
        ImGui::PopID();
        note_item(ui.rects, "lesson edit:right:" + std::to_string(k + 1),
                  question.answer == k ? "right" : "");
    }
    return changed;
}

// The two compared on screen.
std::optional<PatternPair> pair_on_screen(const LessonContext& context) {
    const auto pair = chosen_pair(context.work, context.shown_map);
    if (!pair) return std::nullopt;
    const auto& all = context.work.document.set.vibrations;
    return PatternPair{all[pair->current].name, all[pair->partner].name};
}

bool edit_pairs(const LessonContext& context, LessonQuestion& question) {
    Ui& ui = context.ui;
    std::optional<std::size_t> removed;
    for (std::size_t k = 0; k < question.pairs.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        wrapped_text(question.pairs[k].a + " and " + question.pairs[k].b);
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        if (link(ui, "remove pair", "remove")) removed = k;
        note_item(ui.rects, "lesson edit:remove pair:" + std::to_string(k + 1));
        ImGui::PopID();
    }
    if (removed) {
        question.pairs.erase(question.pairs.begin() + static_cast<std::ptrdiff_t>(*removed));
        return true;
    }
    const auto pair = pair_on_screen(context);
    if (!pair || question.pairs.size() >= limits::kMaxOptions ||
        std::ranges::find(question.pairs, *pair) != question.pairs.end()) {
        return false;
    }
    const bool added = link(ui, "add pair", "Add " + pair->a + " and " + pair->b);
    note_item(ui.rects, "lesson edit:add pair");
    draw_tooltip(ui, "The pattern that is selected, and the one it is compared with");
    if (added) question.pairs.push_back(*pair);
    return added;
}

}  // namespace

void draw_question_editor(const LessonContext& context, LessonState& state) {
    LessonStep step = *step_of(state);
    ImGui::PushFont(context.ui.theme.fonts.small);
    dim_text(context.ui, "Question");
    ImGui::PopFont();
    if (draw_kind(context.ui, step.question)) change_step(context, state, step, "Question");
    if (!step.question) return;
    LessonQuestion& question = *step.question;
    if (edit_text(context.ui, state.box, "##ask", "What is asked", 2, question.ask)) {
        change_step(context, state, step, "What is asked", !state.box.begins_word);
    }
    if (question.kind == QuestionKind::choice && edit_options(context.ui, state.box, question)) {
        change_step(context, state, step, "Options", !state.box.begins_word);
    }
    if (is_of_pairs(question) && edit_pairs(context, question)) {
        change_step(context, state, step, "Pairs");
    }
    if (edit_text(context.ui, state.box, "##reveal", "Said with the answer", 2, question.reveal)) {
        change_step(context, state, step, "Reveal", !state.box.begins_word);
    }
}

}  // namespace tact
