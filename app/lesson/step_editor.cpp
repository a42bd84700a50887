#include "app/lesson/lesson.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/lesson/parts.h"
#include "app/map/map.h"
#include "app/ui/widgets.h"
#include "model/lesson/lesson_lacks.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

void draw_step_buttons(const LessonContext& context, LessonState& state) {
    struct Action {
        const char* label;
        const char* id;
        bool possible;
        void (*act)(const LessonContext&, LessonState&);
    };
    const std::size_t at = *state.step;
    const std::size_t count = state.lesson->steps.size();
    const std::array<Action, 5> actions{
        {{"Add step from screen", "add", count < limits::kMaxSteps, add_step},
         {"Show screen here", "view", true, show_screen},
         {"Up", "up", at > 0, [](const LessonContext& h, LessonState& s) { move_step(h, s, -1); }},
         {"Down", "down", at + 1 < count,
          [](const LessonContext& h, LessonState& s) { move_step(h, s, 1); }},
         {"Remove step", "remove", count > 1, remove_step}}};
    const float gap = context.ui.theme.gap_px;
    for (std::size_t k = 0; k < actions.size(); ++k) {
        const Action& action = actions[k];
        const bool is_up = std::string_view(action.id) == "up";  // stands in one row with Down
        const float with_next = is_up ? gap + button_width(actions[k + 1].label) : 0.0F;
        if (k > 0) flow_on(button_width(action.label) + with_next, gap);
        if (button(context.ui, {.id = std::string("lesson edit:") + action.id,
                                .label = action.label,
                                .enabled = action.possible})) {
            context.ui.waiting.emplace_back(
                [context, &state, act = action.act] { act(context, state); });
        }
    }
}

// Takes the map's camera from the screen.
void draw_camera_row(const LessonContext& context, LessonState& state, const LessonStep& step) {
    const auto later = [&](bool taken) {
        context.ui.waiting.emplace_back(
            [context, &state, taken] { take_camera(context, state, taken); });
    };
    if (link(context.ui,
             {.id = "lesson edit:camera",
              .label = step.camera ? "Camera from the screen again" : "Camera from the screen",
              .value = step.camera ? "kept" : ""})) {
        later(true);
    }
    if (!step.camera) return;
    ImGui::SameLine(0.0F, context.ui.theme.gap_px);
    if (link(context.ui, {.id = "lesson edit:no camera", .label = "leave it unchanged"}))
        later(false);
}

void draw_undo(const LessonContext& context, LessonState& state) {
    struct Way {
        const char* verb;
        const char* id;
        const std::string* label;
        void (*act)(const LessonContext&, LessonState&);
    };
    const std::array<Way, 2> ways{{{"Undo", "undo", state.history.undo_label(), undo_lesson},
                                   {"Redo", "redo", state.history.redo_label(), redo_lesson}}};
    for (const Way& way : ways) {
        if (way.label == nullptr) continue;
        if (link(context.ui, {.id = std::string("lesson edit:") + way.id,
                              .label = menu_text(way.verb, way.label),
                              .value = *way.label})) {
            context.ui.waiting.emplace_back(
                [context, &state, act = way.act] { act(context, state); });
        }
    }
}

// A field shows no numbers: this is the text as the class sees it.
void draw_as_shown(Ui& ui, const LessonState& state) {
    const LessonAnswers* answers = answers_of(state);
    const LessonStep* step = step_of(state);
    if (answers == nullptr || step == nullptr || step->text.empty()) return;
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, "As shown in class");
    ImGui::PopFont();
    wrapped_text(ui, {.id = "lesson edit:shown", .text = filled(step->text, answers->numbers)});
}

// The lesson's name and description, on its first card.
void draw_lesson_name(const LessonContext& context, LessonState& state) {
    LessonWords words{state.shown->name, state.shown->about};
    bool changed =
        edit_text(context.ui, state.box, "##lesson name", "Name of the lesson", 1, words.name);
    changed |= edit_text(context.ui, state.box, "##about", "Who it is for, and how long it takes",
                         2, words.about);
    if (changed) change_name(context, state, words, !state.box.begins_word);
}

}  // namespace

bool edit_text(Ui& ui, TextBox& box, const char* id, const char* label, int lines,
               std::string& text) {
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dim_text);
    wrapped_text(label);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    std::string shown = shown_lines(text);
    const bool changed = draw_text_box(box, id, lines, 2 * lines + 4, shown);
    if (changed) text = std::move(shown);
    note_item(ui.rects, std::string("lesson edit:") + (id + 2), text);
    return changed;
}

void draw_step_editor(const LessonContext& context, LessonState& state) {
    if (*state.step == 0) draw_lesson_name(context, state);
    LessonStep step = *step_of(state);
    struct StepText {
        const char* id;
        const char* label;
        const char* what;
        int lines;
        std::string& text;
    };
    const std::array<StepText, 4> texts{
        {{"##title", "Title", "Title", 1, step.title},
         {"##text", "Text; numbers as {nc | A | B}", "Text", 6, step.text},
         {"##note", "Note for who speaks", "Note", 2, step.note},
         {"##source", "Source of what the text says of the body", "Source", 2, step.source}}};
    for (const StepText& text : texts) {
        if (edit_text(context.ui, state.box, text.id, text.label, text.lines, text.text)) {
            change_step(context, state, step, text.what, !state.box.begins_word);
        }
    }
    draw_as_shown(context.ui, state);
    draw_question_editor(context, state);
    step = *step_of(state);
    if (shows_map(step)) draw_camera_row(context, state, step);
    const std::vector<std::string> lacks = step_lacks(step, context.work.document.set);
    if (!lacks.empty()) {
        coloured_text(context.ui, context.ui.theme.error,
                      {.id = "lesson edit:fault", .text = lacks[0] + "."});
    }
    draw_step_buttons(context, state);
    if (link(context.ui, {.id = "lesson edit:check", .label = "Check the lesson"}))
        check_lesson(context.ui, context.work, state);
    draw_undo(context, state);
}

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
    const auto offer_none = [&] {
        const Item none{.id = "lesson edit:kind:none", .label = "No question"};
        if (!option(ui, none, !question) || !question) return;
        question.reset();
        changed = true;
    };
    const auto offer = [&](std::size_t k) {
        const Item item{.id = std::string("lesson edit:kind:") + kQuestionKinds[k],
                        .label = kKindWords[k]};
        const bool is_this = question && chosen() == k;
        if (!option(ui, item, is_this) || is_this) return;
        if (!question) question.emplace();
        question->kind = static_cast<QuestionKind>(k);
        changed = true;
    };
    const Item shown{.id = "lesson edit:kind",
                     .label = question ? kKindWords[chosen()] : "No question",
                     .value = question ? kQuestionKinds[chosen()] : "none"};
    drop_down(
        ui, shown, -1.0F,
        [&] {
            offer_none();
            for (std::size_t k = 0; k < kKindWords.size(); ++k) offer(k);
        },
        ImGuiComboFlags_HeightRegular);
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
        const bool is_right = question.answer == k;
        ImGui::PushID(static_cast<int>(k));
        if (radio(ui,
                  {.id = "lesson edit:right:" + std::to_string(k + 1),
                   .label = "Right: " + question.options[k],
                   .value = is_right ? "right" : ""},
                  is_right) &&
            !is_right) {
            question.answer = k;
            changed = true;
        }
        ImGui::PopID();
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
        wrapped_text(question.pairs[k].a + " and " + question.pairs[k].b);
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        const std::string id = "lesson edit:remove pair:" + std::to_string(k + 1);
        if (link(ui, {.id = id, .label = "remove"})) removed = k;
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
    const bool added =
        link(ui, {.id = "lesson edit:add pair",
                  .label = "Add " + pair->a + " and " + pair->b,
                  .tip = "The pattern that is selected, and the one it is compared with"});
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
