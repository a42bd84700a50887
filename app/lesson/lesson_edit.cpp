#include "app/lesson/lesson_edit.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "app/ui/widgets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/text/file_stem.h"

namespace tact {

namespace {

void change_lesson(LessonState& state, Lesson lesson) {
    state.lesson = std::make_shared<const Lesson>(std::move(lesson));
    state.tallies.resize(state.lesson->steps.size());
    if (state.job) state.job->submit({state.lesson});
}

void change_step(LessonState& state, const LessonStep& step) {
    Lesson lesson = *state.lesson;
    lesson.steps[*state.step] = step;
    change_lesson(state, std::move(lesson));
}

// What of a text the model cannot give; empty: all is well.
std::string fault_in(const LessonStep& step, const PatternSet& set) {
    for (const std::string& text : texts_of(step)) {
        for (const std::string& placeholder : placeholders_in(text)) {
            const std::string fault = placeholder_fault(placeholder, set);
            if (!fault.empty()) return "{" + placeholder + "}: " + fault + ".";
        }
    }
    return {};
}

bool edit_text(Ui& ui, const char* id, const char* label, int lines, std::string& text) {
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, label);
    ImGui::PopFont();
    const float height = (static_cast<float>(lines) + 0.6F) * ImGui::GetTextLineHeight();
    ImGui::InputTextMultiline(id, &text, {-1.0F, height});
    const bool changed = ImGui::IsItemEdited();
    note_item(ui.rects, std::string("lesson edit:") + (id + 2), text);
    return changed;
}

void draw_step_buttons(const LessonHands& hands, LessonState& state) {
    struct Action {
        const char* label;
        const char* id;
        bool possible;
        void (*act)(const LessonHands&, LessonState&);
    };
    const std::size_t at = *state.step;
    const std::size_t count = state.lesson->steps.size();
    const std::array<Action, 4> actions{
        {{"Add step from screen", "add", count < limits::kMaxSteps, add_step},
         {"Up", "up", at > 0, [](const LessonHands& h, LessonState& s) { move_step(h, s, -1); }},
         {"Down", "down", at + 1 < count,
          [](const LessonHands& h, LessonState& s) { move_step(h, s, 1); }},
         {"Remove step", "remove", count > 1, remove_step}}};
    bool first = true;
    for (const Action& action : actions) {
        if (!std::exchange(first, false)) {
            flow_on(button_width(action.label), hands.ui.theme.gap_px);
        }
        ImGui::BeginDisabled(!action.possible);
        if (ImGui::Button(action.label)) {
            hands.ui.waiting.emplace_back([hands, &state, act = action.act] { act(hands, state); });
        }
        ImGui::EndDisabled();
        note_item(hands.ui.rects, std::string("lesson edit:") + action.id);
    }
}

}  // namespace

LessonStep step_from_screen(const LessonHands& hands) {
    LessonStep step;
    step.title = "New step";
    if (const Vibration* current = current_vibration(hands.work)) step.pattern = current->name;
    step.partner = hands.work.selection.pinned;
    if (const auto& open = hands.physiology.view.open) step.view = text_of(*open).key;
    if (hands.layout.maximised == Pane::space) step.view = "map";
    const Playhead& playhead = hands.timeline.playhead;
    step.at_s = playhead.at_s;
    step.speed = playhead.playing ? playhead.speed : 0.0;
    const bool whole = hands.timeline.range.length_s() >= shown_duration_s(hands.work) - 1e-9;
    if (!whole) {
        step.from_s = hands.timeline.range.start_s;
        step.to_s = hands.timeline.range.end_s;
    }
    if (step.view == "map") {
        const SpaceCamera& camera = hands.shown_map.camera;
        step.camera = LessonCamera{camera.yaw_rad, camera.pitch_rad, camera.zoom};
    }
    return step;
}

void new_lesson(const LessonHands& hands, LessonState& state) {
    leave_lesson(hands, state);
    Lesson lesson;
    lesson.name = hands.work.document.set.name + ", a lesson";
    lesson.set = hands.work.document.set;
    lesson.steps = {step_from_screen(hands)};
    state.before = view_of(hands);
    state.path.clear();
    state.is_tour = false;
    state.editing = true;
    change_lesson(state, std::move(lesson));
    state.step = 0;
}

void toggle_editing(const LessonHands& hands, LessonState& state) {
    if (!state.step) return complain(hands.ui, "Open a lesson first, or begin a new one.");
    state.editing = !state.editing;
    state.presenting = false;
    if (!state.editing) go_to_step(hands, state, *state.step);
}

void add_step(const LessonHands& hands, LessonState& state) {
    if (!state.step || state.lesson->steps.size() >= limits::kMaxSteps) return;
    Lesson lesson = *state.lesson;
    const auto behind = static_cast<std::ptrdiff_t>(*state.step + 1);
    lesson.steps.insert(lesson.steps.begin() + behind, step_from_screen(hands));
    change_lesson(state, std::move(lesson));
    state.editing = true;
    ++*state.step;
}

void remove_step(const LessonHands& hands, LessonState& state) {
    if (!state.step || state.lesson->steps.size() < 2) return;
    Lesson lesson = *state.lesson;
    lesson.steps.erase(lesson.steps.begin() + static_cast<std::ptrdiff_t>(*state.step));
    change_lesson(state, std::move(lesson));
    go_to_step(hands, state, *state.step);
}

void move_step(const LessonHands& hands, LessonState& state, int by) {
    if (!state.step) return;
    const auto to = static_cast<std::ptrdiff_t>(*state.step) + by;
    if (to < 0 || to >= std::ssize(state.lesson->steps)) return;
    Lesson lesson = *state.lesson;
    std::swap(lesson.steps[*state.step], lesson.steps[static_cast<std::size_t>(to)]);
    change_lesson(state, std::move(lesson));
    go_to_step(hands, state, static_cast<std::size_t>(to));
}

void draw_step_editor(const LessonHands& hands, LessonState& state) {
    LessonStep step = state.lesson->steps[*state.step];
    bool changed = edit_text(hands.ui, "##title", "Title", 1, step.title);
    changed |=
        edit_text(hands.ui, "##text", "Text; numbers of the model in braces, such as {nc | A | B}",
                  6, step.text);
    changed |= edit_text(hands.ui, "##note", "Note for who speaks", 2, step.note);
    if (changed) change_step(state, step);
    const std::string fault = fault_in(step, hands.work.document.set);
    if (!fault.empty()) {
        coloured_text(hands.ui.theme.error, fault);
        note_item(hands.ui.rects, "lesson edit:fault", fault);
    }
    draw_step_buttons(hands, state);
}

Lesson lesson_to_save(const Workspace& work, const LessonState& state) {
    Lesson lesson = *state.lesson;
    if (lesson.set == work.document.set) return lesson;
    lesson.set = work.document.set;
    lesson.set_name.clear();
    return lesson;
}

void save_lesson_dialog(Ui& ui, const Workspace& work, const LessonState& state) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::save_lesson,
                  .use = ChooserUse::save,
                  .title = "Save the lesson",
                  .extensions = {kLessonEnding}},
                 state.path.empty() ? work.document.path.parent_path() : state.path.parent_path(),
                 file_stem(state.lesson->name) + kLessonEnding);
}

void save_lesson(Ui& ui, const Workspace& work, LessonState& state,
                 const std::filesystem::path& path) {
    std::filesystem::path target = std::filesystem::absolute(path);
    if (!is_lesson_file(target)) target += kLessonEnding;
    const Lesson lesson = lesson_to_save(work, state);
    if (const auto written = write_lesson_file(target, lesson); !written) {
        return complain(ui, "Not saved: " + written.error().message);
    }
    state.path = target;
    say(ui, "Saved the lesson " + target.string() + ".");
}

void open_lesson_dialog(Ui& ui, const Workspace& work) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::open_lesson,
                  .use = ChooserUse::open,
                  .title = "Open a lesson",
                  .extensions = {".json"}},
                 work.document.path.parent_path());
}

void save_sheet_dialog(Ui& ui, const Workspace& work, const LessonState& state) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::lesson_sheet,
                  .use = ChooserUse::save,
                  .title = "Student sheet of the lesson",
                  .extensions = {".html"}},
                 work.document.path.parent_path(), file_stem(state.lesson->name) + ".html");
}

}  // namespace tact
