#include "app/lesson/lesson_edit.h"

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/ui/file_question.h"
#include "model/io/lesson/lesson_file.h"
#include "model/text/file_stem.h"

namespace tact {

namespace {

void keep(LessonState& state, Lesson lesson) {
    state.lesson = std::make_shared<const Lesson>(std::move(lesson));
    state.tallies.resize(state.lesson->steps.size());
    if (state.job) state.job->submit({state.lesson});
}

void show_kept(const LessonHands& hands, LessonState& state, std::shared_ptr<const Lesson> kept) {
    if (!kept || !state.step) return;
    state.lesson = std::move(kept);
    state.tallies.resize(state.lesson->steps.size());
    state.edited_at = hands.work.revision;
    if (state.job) state.job->submit({state.lesson});
    go_to_step(hands, state, *state.step);
}

}  // namespace

void change_lesson(const LessonHands& hands, LessonState& state, Lesson lesson,
                   const std::string& what, bool joins) {
    const auto before = state.lesson;
    keep(state, std::move(lesson));
    const std::string* last = state.history.undo_label();
    // Letters of one text are one step of undo.
    if (joins && last != nullptr && *last == what) {
        state.history.join(before, state.lesson, what);
    } else {
        state.history.commit(before, state.lesson, what);
    }
    state.edited_at = hands.work.revision;
}

void change_step(const LessonHands& hands, LessonState& state, const LessonStep& step,
                 const std::string& what, bool joins) {
    Lesson lesson = *state.lesson;
    lesson.steps[*state.step] = step;
    change_lesson(hands, state, std::move(lesson),
                  what + " of step " + std::to_string(*state.step + 1), joins);
}

void undo_lesson(const LessonHands& hands, LessonState& state) {
    show_kept(hands, state, state.history.undo());
}

void redo_lesson(const LessonHands& hands, LessonState& state) {
    show_kept(hands, state, state.history.redo());
}

bool was_lesson_edited_last(const Workspace& work, const LessonState& state) {
    return state.editing && state.edited_at == work.revision;
}

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
    const TimeRange range = unless_whole(hands.timeline.range, shown_duration_s(hands.work));
    step.from_s = range.start_s;
    step.to_s = range.end_s;
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
    state.history.clear();
    keep(state, std::move(lesson));
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
    change_lesson(hands, state, std::move(lesson), "Add step");
    state.editing = true;
    ++*state.step;
}

void remove_step(const LessonHands& hands, LessonState& state) {
    if (!state.step || state.lesson->steps.size() < 2) return;
    Lesson lesson = *state.lesson;
    lesson.steps.erase(lesson.steps.begin() + static_cast<std::ptrdiff_t>(*state.step));
    change_lesson(hands, state, std::move(lesson), "Remove step");
    go_to_step(hands, state, *state.step);
}

void show_screen(const LessonHands& hands, LessonState& state) {
    if (!state.step) return;
    LessonStep step = step_from_screen(hands);
    const LessonStep& was = state.lesson->steps[*state.step];
    step.title = was.title;
    step.text = was.text;
    step.note = was.note;
    step.source = was.source;
    step.point_at = was.point_at;
    step.question = was.question;
    change_step(hands, state, step, "View");
}

void take_camera(const LessonHands& hands, LessonState& state, bool taken) {
    if (!state.step) return;
    LessonStep step = state.lesson->steps[*state.step];
    const SpaceCamera& camera = hands.shown_map.camera;
    step.camera.reset();
    if (taken) step.camera = LessonCamera{camera.yaw_rad, camera.pitch_rad, camera.zoom};
    change_step(hands, state, step, "Camera");
}

void move_step(const LessonHands& hands, LessonState& state, int by) {
    if (!state.step) return;
    const auto to = static_cast<std::ptrdiff_t>(*state.step) + by;
    if (to < 0 || to >= std::ssize(state.lesson->steps)) return;
    Lesson lesson = *state.lesson;
    std::swap(lesson.steps[*state.step], lesson.steps[static_cast<std::size_t>(to)]);
    change_lesson(hands, state, std::move(lesson), "Move step");
    go_to_step(hands, state, static_cast<std::size_t>(to));
}

Lesson lesson_to_save(const Workspace& work, const LessonState& state) {
    Lesson lesson = *state.lesson;
    for (LessonStep& step : lesson.steps) {  // a line that was begun is no option yet
        while (step.question && !step.question->options.empty() &&
               step.question->options.back().empty()) {
            step.question->options.pop_back();
        }
    }
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
