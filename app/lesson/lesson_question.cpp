#include "app/lesson/lesson.h"

#include <algorithm>
#include <string>

#include "app/ui/widgets.h"
#include "model/lesson/lesson_lacks.h"
#include "viz/drawing/colour.h"

namespace tact {

namespace {

constexpr const char* kTick = "   \u2713";

// The answer to a step's question; null until it is computed.
const QuestionAnswer* answer_at(const LessonState& state, std::size_t step) {
    const LessonAnswers* answers = answers_of(state);
    if (answers == nullptr || step >= answers->questions.size()) return nullptr;
    return &answers->questions[step];
}

bool is_right(const QuestionAnswer& answer, std::size_t option) {
    return std::ranges::find(answer.right, option) != answer.right.end();
}

std::string option_text(const LessonState& state, const QuestionAnswer& answer, std::size_t k) {
    return std::to_string(k + 1) + "  " + filled(answer.options[k], answers_of(state)->numbers);
}

void draw_option(Ui& ui, LessonState& state, const QuestionAnswer& answer, std::size_t k) {
    const Tally& tally = state.tallies[*state.step];
    const bool right = (tally.revealed || state.editing) && is_right(answer, k);
    std::string text = option_text(state, answer, k);
    if (tally.votes[k] > 0) text += "   " + std::to_string(tally.votes[k]);
    if (right) text += kTick;
    read_out(ui, text);
    ImGui::PushID(static_cast<int>(k));
    if (right) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.accent);
    wrapped_text(text);
    if (right) ImGui::PopStyleColor();
    if (ImGui::IsItemClicked()) vote(state, k);
    if (ImGui::IsItemHovered() && !tally.revealed) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    note_item(ui.rects, "option:" + std::to_string(k + 1),
              std::to_string(tally.votes[k]) + (right ? " right" : ""));
    ImGui::PopID();
}

constexpr std::size_t kManyOptions = 6;  // more would fill a small window if stacked

// Options stand side by side in a low card or if there are many; rows are as long as the longest
// option allows, and the last row is about as long as the others. A vote or a tick moves nothing.
void draw_options(Ui& ui, LessonState& state, const QuestionAnswer& answer) {
    const std::size_t count = answer.options.size();
    float widest = 0.0F;
    for (std::size_t k = 0; k < count; ++k) {
        const float width = ImGui::CalcTextSize(option_text(state, answer, k).c_str()).x;
        widest = std::max(widest, width);
    }
    widest += ImGui::CalcTextSize("   88").x + ImGui::CalcTextSize(kTick).x + ui.theme.gap_px;
    const float all = ImGui::GetContentRegionAvail().x;
    const auto most = static_cast<std::size_t>(std::max(1.0F, all / widest));
    const bool low = state.dock == DockSide::bottom || state.dock == DockSide::top;
    const bool beside = !state.editing && (low || count >= kManyOptions);
    if (!beside || count < 2 || most < 2) {
        for (std::size_t k = 0; k < count; ++k) draw_option(ui, state, answer, k);
        return;
    }
    const std::size_t rows = (count + most - 1) / most;
    const std::size_t columns = (count + rows - 1) / rows;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.0F, 0.5F * ImGui::GetStyle().ItemSpacing.y});
    if (ImGui::BeginTable("options", static_cast<int>(columns),
                          ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_NoSavedSettings |
                              ImGuiTableFlags_SizingFixedSame)) {
        for (std::size_t k = 0; k < columns; ++k) {
            ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, widest);
        }
        for (std::size_t k = 0; k < count; ++k) {
            ImGui::TableNextColumn();
            draw_option(ui, state, answer, k);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

// Whether the answer was scrolled into view since it was revealed.
bool& answer_seen(const LessonState& state) {
    const ImGuiID id = ImGui::GetID("answer seen") + static_cast<ImGuiID>(*state.step);
    return *ImGui::GetStateStorage()->GetBoolRef(id, false);
}

// Text of the answer: the step's words, the class's place, the model, people.
std::string reveal_words(const LessonState& state, const LessonQuestion& question,
                         const QuestionAnswer& answer, const std::string& place) {
    std::string text = filled(question.reveal, answers_of(state)->numbers);
    for (const std::string& more : {place, answer.model, answer.people}) {
        if (!more.empty()) text += (text.empty() ? "" : " ") + more;
    }
    return text;
}

void draw_answer(Ui& ui, const LessonState& state, const LessonQuestion& question,
                 const QuestionAnswer& answer, const std::string& place) {
    std::string text = reveal_words(state, question, answer, place);
    const LessonScore score = score_of(state);
    if (score.asked > 0) {
        text += " Right so far: " + std::to_string(score.right) + " of " +
                std::to_string(score.asked) + ".";
    }
    wrapped_text(ui, {.id = "lesson:answer", .text = text});
    // A short card scrolls to the answer when it is revealed.
    bool& seen = answer_seen(state);
    if (!seen) ImGui::SetScrollHereY(1.0F);
    seen = true;
    read_out(ui, text);
}

void draw_small(const Ui& ui, const LessonState& state, const char* text) {
    ImGui::PushFont(lesson_fonts(ui, state).small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace

const LessonQuestion* question_of(const LessonState& state) {
    const LessonStep* step = step_of(state);
    if (step == nullptr || !step->question) return nullptr;
    const bool is_seen = state.editing || is_question_whole(*step, state.lesson->set);
    return is_seen ? &*step->question : nullptr;
}

bool hides_answer(const LessonState& state) {
    return question_of(state) != nullptr && !state.editing && *state.step < state.tallies.size() &&
           !state.tallies[*state.step].revealed;
}

void draw_lesson_question(const LessonContext& context, LessonState& state,
                          const LessonQuestion& question) {
    Ui& ui = context.ui;
    const LessonAnswers* answers = answers_of(state);
    const QuestionAnswer* answer = answer_at(state, *state.step);
    ImGui::Spacing();
    ImGui::PushFont(lesson_fonts(ui, state).head);
    const LessonNumbers none;
    const std::string ask = filled(question.ask, answers == nullptr ? none : answers->numbers);
    wrapped_text(ask);
    read_out(ui, ask);
    ImGui::PopFont();
    if (answer == nullptr) return dim_text(ui, "The model is on its way.");
    const bool hidden = hides_answer(state);
    if (hidden && question.kind == QuestionKind::place) {
        draw_small(ui, state,
                   "Click in the map where it belongs, or move the cross with Shift and the "
                   "arrows. Or say next to which it lies:");
    }
    draw_options(ui, state, *answer);
    if (hidden) {
        answer_seen(state) = false;
        return draw_small(ui, state, "Number keys count hands; the next step forward reveals.");
    }
    draw_answer(ui, state, question, *answer, place_text(state, context.shown_map));
}

bool vote(LessonState& state, std::size_t option) {
    if (!hides_answer(state)) return false;
    const QuestionAnswer* answer = answer_at(state, *state.step);
    if (answer == nullptr || option >= answer->options.size()) return false;
    ++state.tallies[*state.step].votes[option];
    return true;
}

std::optional<QuestionInWords> question_in_words(const LessonState& state) {
    const LessonQuestion* question = question_of(state);
    if (question == nullptr || *state.step >= state.tallies.size()) return std::nullopt;
    const QuestionAnswer* answer = answer_at(state, *state.step);
    if (answer == nullptr) return std::nullopt;
    const LessonNumbers& numbers = answers_of(state)->numbers;
    QuestionInWords words{filled(question->ask, numbers), {}, !hides_answer(state), {}, {}};
    for (const std::string& option : answer->options) {
        words.options.push_back(filled(option, numbers));
    }
    if (!words.is_revealed) return words;
    words.right = answer->right;
    words.reveal = reveal_words(state, *question, *answer, {});
    return words;
}

void count_elsewhere(LessonState& state, const std::vector<int>& votes) {
    if (!hides_answer(state)) return;
    Tally& tally = state.tallies[*state.step];
    for (std::size_t k = 0; k < std::min(votes.size(), tally.votes.size()); ++k) {
        tally.votes[k] += votes[k] - tally.elsewhere[k];
        tally.elsewhere[k] = votes[k];
    }
}

LessonScore score_of(const LessonState& state) {
    LessonScore score;
    for (std::size_t k = 0; k < state.tallies.size(); ++k) {
        const Tally& tally = state.tallies[k];
        const QuestionAnswer* answer = answer_at(state, k);
        const auto most = std::ranges::max_element(tally.votes);
        if (!tally.revealed || answer == nullptr) continue;
        if (*most == 0 && !tally.place) continue;
        ++score.asked;
        if (*most == 0) continue;  // no votable pattern is near the place
        const auto option = static_cast<std::size_t>(most - tally.votes.begin());
        if (is_right(*answer, option)) ++score.right;
    }
    return score;
}

}  // namespace tact
