#include "app/lesson/lesson.h"

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/picture/picture.h"

namespace tact {

namespace {

constexpr double kPointerRestsS = 3.0;

bool is_plain(const KeyPress& press) { return !press.ctrl && !press.alt && !press.super; }

bool is_on(const KeyPress& press) {
    return press.code == key::kPageDown || press.code == key::kRight || press.code == key::kDown ||
           press.code == key::kEnter || press.code == key::kKeypadEnter ||
           press.code == key::kSpace;
}

bool is_back(const KeyPress& press) {
    return press.code == key::kPageUp || press.code == key::kLeft || press.code == key::kUp ||
           press.code == key::kBackspace;
}

// While presenting, every key belongs to the lesson.
bool take_presenting_key(const LessonContext& context, LessonState& state, const KeyPress& press) {
    if (state.blank && press.code != key::kEscape) {
        state.blank = false;
        return true;
    }
    if (is_on(press)) {
        step_on(context, state);
    } else if (is_back(press)) {
        step_back(context, state);
    } else if (press.code == key::kHome) {
        go_to_step(context, state, 0);
    } else if (press.code == key::kEnd) {
        go_to_step(context, state, state.lesson->steps.size() - 1);
    } else if (press.sign == 'b' || press.sign == '.') {
        state.blank = true;
    } else if (press.sign == 'm') {
        move_card(state);
    } else if (press.sign == 'n') {
        toggle_notes(state);
    } else if (press.sign == 'p') {
        context.timeline.playhead.playing = !context.timeline.playhead.playing;
    } else {
        return false;
    }
    return true;
}

bool take_vote(LessonState& state, const KeyPress& press) {
    if (press.sign < '1' || press.sign > '9') return false;
    return vote(state, static_cast<std::size_t>(press.sign - U'1'));
}

// Order of the steps, and undo of the last edit.
bool take_editing_key(const LessonContext& context, LessonState& state, const KeyPress& press) {
    const bool moves = press.alt && !press.ctrl && !press.super;
    if (moves && (press.code == key::kPageUp || press.code == key::kPageDown)) {
        move_step(context, state, press.code == key::kPageUp ? -1 : 1);
        return true;
    }
    if (!press.ctrl || press.alt || !was_lesson_edited_last(context.work, state)) return false;
    const bool redoes = press.sign == 'y' || (press.sign == 'z' && press.shift);
    const bool undoes = press.sign == 'z' && !press.shift;
    const std::string* label = undoes   ? state.history.undo_label()
                               : redoes ? state.history.redo_label()
                                        : nullptr;
    if (label == nullptr) return false;
    undoes ? undo_lesson(context, state) : redo_lesson(context, state);
    return true;
}

bool take_key(const LessonContext& context, LessonState& state, const KeyPress& press) {
    if (!state.step) return false;
    if (state.editing && take_editing_key(context, state, press)) return true;
    if (!is_plain(press)) return false;
    if (take_vote(state, press)) return true;
    if (nudge_place(state, context.shown_map, press)) return true;
    if (state.presenting) return take_presenting_key(context, state, press);
    if (press.code == key::kPageDown) {
        step_on(context, state);
    } else if (press.code == key::kPageUp) {
        step_back(context, state);
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool is_presenting(const LessonState& state) { return state.presenting && state.step; }

float presented_growth(ImVec2 screen_px) {
    return std::clamp(std::min(screen_px.x / 1280.0F, screen_px.y / 720.0F), 0.8F, 4.0F);
}

Lesson lesson_of_set(const Workspace& work) {
    const PatternSet& set = work.document.set;
    Lesson lesson;
    lesson.name = set.name;
    std::vector<LessonStep> steps;
    for (const Vibration& vibration : set.vibrations) {
        if (vibration.dropped) continue;
        LessonStep step;
        step.title = step.pattern = vibration.name;
        step.note = vibration.note;
        steps.push_back(std::move(step));
    }
    if (steps.size() > 1) {
        LessonStep map;
        map.title = set.name.empty() ? "The map" : set.name;
        map.text = counted(steps.size(), "pattern", "patterns") +
                   ". Those that lie near each other are alike to the model.";
        if (const Vibration* current = current_vibration(work)) map.pattern = current->name;
        map.view = "map";
        steps.insert(steps.begin(), std::move(map));
    }
    lesson.steps = std::move(steps);
    return lesson;
}

namespace {

// False: there is nothing to present.
bool start_set(const LessonContext& context, LessonState& state) {
    Lesson lesson = lesson_of_set(context.work);
    if (lesson.steps.empty()) return false;
    state.before = view_of(context);
    state.document_number = context.work.document_number;
    state.path.clear();
    state.key.clear();
    state.is_tour = state.editing = state.is_written = false;
    state.is_of_set = true;
    state.history.clear();
    show_lesson(state, std::make_shared<const Lesson>(std::move(lesson)));
    state.tallies.assign(state.lesson->steps.size(), {});
    state.step = 0;
    return true;
}

}  // namespace

void toggle_presenting(const LessonContext& context, LessonState& state) {
    if (is_presenting(state) && state.is_of_set) {
        leave_lesson(context, state);
        return;
    }
    if (is_presenting(state)) {
        state.presenting = state.blank = false;
        state.present_scale = context.ui.text_scale;
        set_text_scale(context.ui, state.before.text_scale);
        return;
    }
    const bool is_new = !state.step;
    if (is_new && !start_set(context, state)) start_bundled_lesson(context, state, kTourLesson);
    if (!state.step) return;
    state.presenting = true;
    state.presenting_since_s = context.ui.time_s;
    state.editing = false;
    go_to_step(context, state, *state.step);
    set_text_scale(context.ui, state.present_scale);
    if (is_new) ask_where_to_begin(context, state);
}

std::vector<KeyPress> take_lesson_keys(const LessonContext& context, LessonState& state,
                                       std::span<const KeyPress> pressed) {
    std::vector<KeyPress> left;
    const bool typing = ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
    const bool covered = context.ui.dialog != kNoDialog || context.ui.chooser.is_open ||
                         context.ui.question.has_value();
    for (const KeyPress& press : pressed) {
        // A text field has no undo of its own; the lesson's includes its edits.
        const bool is_of_box = typing && !covered && state.editing && state.box.id != 0;
        if (is_of_box && press.ctrl && take_editing_key(context, state, press)) continue;
        if (typing || covered || !take_key(context, state, press)) left.push_back(press);
    }
    return left;
}

void draw_over_presentation(Ui& ui, const LessonState& state) {
    if (!is_presenting(state)) return;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    if (state.blank) {
        list.AddRectFilled({0.0F, 0.0F}, screen, IM_COL32_BLACK);
        note_rect(ui.rects, "blank", {0.0F, 0.0F}, screen);
        return;
    }
    if (ui.time_s - ui.hover_since_s > kPointerRestsS || !ImGui::IsMousePosValid()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    list.AddCircleFilled(mouse, 16.0F * ui.theme.scale, faded(ui.theme.accent, 0.25F), 32);
    list.AddCircle(mouse, 16.0F * ui.theme.scale, ui.theme.accent, 32, 2.0F * ui.theme.scale);
}

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
