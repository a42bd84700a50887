#include "app/lesson/speaker_notes.h"

#include <algorithm>
#include <cmath>

#include "app/lesson/presenting.h"
#include "app/ui/widgets.h"
#include "viz/picture/picture.h"

namespace tact {

namespace {

constexpr double kMinuteS = 60.0;
constexpr float kNotesText = 2.0F;  // readable from a lectern

std::string right_of(const QuestionAnswer& answer, const LessonNumbers& numbers) {
    std::string text;
    for (const std::size_t place : answer.right) {
        text += (text.empty() ? "" : "; ") + filled(answer.options[place], numbers);
    }
    return text;
}

void draw_words(const Theme& theme, ImFont* font, ImU32 colour, const std::string& text) {
    if (text.empty()) return;
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    wrapped_text(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::Dummy({0.0F, theme.gap_px});
}

}  // namespace

std::optional<SpeakerNotes> speaker_notes(const LessonState& state, double now_s) {
    const LessonStep* step = step_of(state);
    if (step == nullptr || !state.presenting) return std::nullopt;
    const LessonAnswers* answers = answers_of(state);
    const LessonNumbers none;
    const LessonNumbers& numbers = answers == nullptr ? none : answers->numbers;
    const std::size_t at = *state.step;
    SpeakerNotes notes;
    notes.count = std::to_string(at + 1) + " of " + std::to_string(state.shown->steps.size());
    notes.title = filled(step->title, numbers);
    notes.note = filled(step->note, numbers);
    if (step->question && answers != nullptr && at < answers->questions.size()) {
        notes.answer = right_of(answers->questions[at], numbers);
    }
    if (at + 1 < state.shown->steps.size()) {
        notes.next = filled(state.shown->steps[at + 1].title, numbers);
    }
    notes.minutes = static_cast<int>(std::max(0.0, now_s - state.presenting_since_s) / kMinuteS);
    return notes;
}

std::string speaker_line(const LessonState& state) {
    const auto notes = speaker_notes(state, state.presenting_since_s);
    if (!notes) return {};
    std::string line = std::to_string(*state.step + 1) + "/" +
                       std::to_string(state.shown->steps.size()) + "  " +
                       (notes->note.empty() ? notes->title : notes->note);
    if (!notes->answer.empty()) line += "  | answer: " + notes->answer;
    if (!notes->next.empty()) line += "  | next: " + notes->next;
    std::ranges::replace(line, '\n', ' ');
    return line;
}

void draw_speaker_notes(const Theme& theme, const SpeakerNotes& notes) {
    const float edge = 2.0F * theme.padding_px;
    const ImVec2 all = ImGui::GetWindowSize();
    ImGui::SetCursorPos({edge, edge});
    ImGui::BeginChild("notes", {all.x - 2.0F * edge, all.y - 2.0F * edge});
    draw_words(theme, theme.fonts.small, theme.dim_text,
               notes.count + " \u00b7 " + std::to_string(notes.minutes) + " min");
    draw_words(theme, theme.fonts.semibold, theme.text, notes.title);
    draw_words(theme, theme.fonts.regular, theme.text,
               notes.note.empty() ? "No note for this step." : notes.note);
    if (!notes.answer.empty()) {
        draw_words(theme, theme.fonts.regular, theme.accent, "Answer: " + notes.answer);
    }
    draw_words(theme, theme.fonts.regular, theme.dim_text,
               notes.next.empty() ? "The last step." : "Next: " + notes.next);
    ImGui::EndChild();
}

bool wants_notes_window(const LessonState& state, bool second_screen) {
    return is_presenting(state) && state.notes_wanted.value_or(second_screen);
}

SideContent notes_window(const SpeakerNotes& notes, bool dark) {
    SideContent content;
    content.title = "Notes - tactspace";
    content.key = notes.count + "\n" + notes.title + "\n" + notes.note + "\n" + notes.answer +
                  "\n" + notes.next + "\n" + std::to_string(notes.minutes) + (dark ? "d" : "l");
    content.draw = [notes, dark](int width, int height, float content_scale) {
        PictureOptions options;
        options.dark = dark;
        options.scale = content_scale * kNotesText;
        options.extra_text = notes.title + notes.note + notes.answer + notes.next;
        return draw_picture(width, height, options,
                            [&notes](const Theme& theme) { draw_speaker_notes(theme, notes); });
    };
    return content;
}

void toggle_notes(LessonState& state) { state.notes_wanted = !state.shows_notes; }

double notes_wake_s(const LessonState& state, double now_s) {
    const double since_s = std::max(0.0, now_s - state.presenting_since_s);
    return (std::floor(since_s / kMinuteS) + 1.0) * kMinuteS - since_s + 0.01;
}

}  // namespace tact
