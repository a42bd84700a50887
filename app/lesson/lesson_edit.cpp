#include "app/lesson/lesson.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_lacks.h"
#include "model/lesson/lesson_languages.h"
#include "model/text/names.h"

namespace tact {

namespace {

void keep(LessonState& state, Lesson lesson) {
    show_lesson(state, std::make_shared<const Lesson>(std::move(lesson)));
}

void show_kept(const LessonContext& context, LessonState& state,
               std::shared_ptr<const Lesson> kept) {
    if (!kept || !state.step) return;
    show_lesson(state, std::move(kept));
    state.edited_at = context.work.revision;
    go_to_step(context, state, *state.step);
}

// Angles without full turns.
LessonCamera camera_on(const LessonContext& context) {
    const SpaceCamera& camera = context.shown_map.camera;
    return {std::remainder(camera.yaw_rad, 2.0 * std::numbers::pi),
            std::remainder(camera.pitch_rad, 2.0 * std::numbers::pi),
            std::clamp(camera.zoom, limits::kLessonZoom.low, limits::kLessonZoom.high)};
}

}  // namespace

void change_lesson(const LessonContext& context, LessonState& state, Lesson lesson,
                   const std::string& what, bool joins) {
    const auto before = state.lesson;
    if (!(lesson.set == context.work.document.set)) {  // its numbers depend on the screen
        lesson.set = lesson_to_save(context.work, state).set;
        if (!(lesson.set == before->set)) lesson.set_name.clear();
    }
    keep(state, std::move(lesson));
    const std::string* last = state.history.undo_label();
    // Letters typed into one word are one step of undo.
    if (joins && last != nullptr && *last == what) {
        state.history.join(before, state.lesson, what);
    } else {
        state.history.commit(before, state.lesson, what);
    }
    state.edited_at = context.work.revision;
}

void change_step(const LessonContext& context, LessonState& state, const LessonStep& step,
                 const std::string& what, bool joins) {
    Lesson lesson = *state.lesson;
    LessonStep& stored = lesson.steps[*state.step];
    stored = with_words(stored, *step_of(state), step, shown_language(state));
    change_lesson(context, state, std::move(lesson),
                  what + " of step " + std::to_string(*state.step + 1), joins);
}

void undo_lesson(const LessonContext& context, LessonState& state) {
    show_kept(context, state, state.history.undo());
}

void redo_lesson(const LessonContext& context, LessonState& state) {
    show_kept(context, state, state.history.redo());
}

bool was_lesson_edited_last(const Workspace& work, const LessonState& state) {
    return state.editing && state.edited_at == work.revision;
}

LessonStep step_from_screen(const LessonContext& context) {
    LessonStep step;
    step.title = "New step";
    if (const Vibration* current = current_vibration(context.work)) step.pattern = current->name;
    step.partner = context.work.selection.pinned;
    if (const auto& open = context.physiology.view.open) step.view = text_of(*open).key;
    if (context.layout.maximised == Pane::space) step.view = "map";
    const Playhead& playhead = context.timeline.playhead;
    step.at_s = playhead.at_s;
    step.speed = playhead.playing ? playhead.speed : 0.0;
    const TimeRange range = unless_whole(context.timeline.range, shown_duration_s(context.work));
    step.from_s = range.start_s;
    step.to_s = range.end_s;
    if (step.view == "map") {
        step.camera = camera_on(context);
    }
    return step;
}

void new_lesson(const LessonContext& context, LessonState& state) {
    Lesson lesson;
    if (!leave_lesson(context, state)) return;
    lesson.name = context.work.document.set.name + ", a lesson";
    lesson.set = context.work.document.set;
    lesson.steps = {step_from_screen(context)};
    write_on_document(context, state, std::make_shared<const Lesson>(std::move(lesson)));
}

void write_on_document(const LessonContext& context, LessonState& state,
                       std::shared_ptr<const Lesson> lesson) {
    if (!leave_lesson(context, state)) return;
    state.before = view_of(context);
    state.document_number = context.work.document_number;
    state.path.clear();
    state.key.clear();
    state.is_tour = state.is_of_set = false;
    state.editing = state.is_written = true;
    state.history.clear();
    keep(state, *lesson);
    state.step = 0;
    note_lesson_saved(context.work, state);
}

void toggle_editing(const LessonContext& context, LessonState& state) {
    if (!state.step) return complain(context.ui, "Open a lesson first, or begin a new one.");
    state.editing = !state.editing;
    state.is_written |= state.editing;
    state.presenting = false;
    if (!state.editing) go_to_step(context, state, *state.step);
}

void add_step(const LessonContext& context, LessonState& state) {
    if (!state.step || state.lesson->steps.size() >= limits::kMaxSteps) return;
    Lesson lesson = *state.lesson;
    const auto behind = static_cast<std::ptrdiff_t>(*state.step + 1);
    lesson.steps.insert(lesson.steps.begin() + behind, step_from_screen(context));
    state.editing = state.is_written = true;
    change_lesson(context, state, std::move(lesson), "Add step");
    ++*state.step;
}

void remove_step(const LessonContext& context, LessonState& state) {
    if (!state.step || state.lesson->steps.size() < 2) return;
    Lesson lesson = *state.lesson;
    lesson.steps.erase(lesson.steps.begin() + static_cast<std::ptrdiff_t>(*state.step));
    change_lesson(context, state, std::move(lesson), "Remove step");
    go_to_step(context, state, *state.step);
}

void show_screen(const LessonContext& context, LessonState& state) {
    if (!state.step) return;
    LessonStep step = step_from_screen(context);
    const LessonStep& was = *step_of(state);
    step.title = was.title;
    step.text = was.text;
    step.note = was.note;
    step.source = was.source;
    step.point_at = was.point_at;
    step.question = was.question;
    change_step(context, state, step, "View");
}

void take_camera(const LessonContext& context, LessonState& state, bool taken) {
    if (!state.step) return;
    LessonStep step = *step_of(state);
    step.camera.reset();
    if (taken) step.camera = camera_on(context);
    change_step(context, state, step, "Camera");
}

void move_step(const LessonContext& context, LessonState& state, int by) {
    if (!state.step) return;
    const auto to = static_cast<std::ptrdiff_t>(*state.step) + by;
    if (to < 0 || to >= std::ssize(state.lesson->steps)) return;
    Lesson lesson = *state.lesson;
    std::swap(lesson.steps[*state.step], lesson.steps[static_cast<std::size_t>(to)]);
    change_lesson(context, state, std::move(lesson), "Move step");
    go_to_step(context, state, static_cast<std::size_t>(to));
}

void add_language(const LessonContext& context, LessonState& state, const std::string& code) {
    if (!state.step) return;
    const bool names_none = state.lesson->languages.empty();
    change_lesson(context, state, with_language(*state.lesson, code), "Add " + language_name(code));
    choose_language(context.ui, state, code);
    std::string text = "What is written now is " + language_name(code) +
                       "; what is not written yet shows in the first language.";
    if (names_none) text += " The texts so far are taken as English.";
    say(context.ui, text);
}

void remove_language(const LessonContext& context, LessonState& state) {
    const std::size_t place = shown_language(state);
    if (!state.step || place == 0) return;
    const std::string name = language_name(state.lesson->languages[place]);
    change_lesson(context, state, without_language(*state.lesson, place), "Remove " + name);
}

void change_name(const LessonContext& context, LessonState& state, const LessonWords& shown,
                 bool joins) {
    if (!state.step) return;
    change_lesson(context, state, with_words(*state.lesson, shown, shown_language(state)),
                  "Name of the lesson", joins);
}

void duplicate_lesson(const LessonContext& context, LessonState& state) {
    if (!state.step) return;
    Lesson copy = lesson_to_save(context.work, state);
    copy.name += " copy";
    state.path.clear();
    state.key.clear();
    state.is_tour = false;
    state.presenting = false;
    state.editing = state.is_written = true;
    state.history.clear();
    keep(state, std::move(copy));
    state.saved = std::make_shared<const Lesson>();  // no part of it is in a file yet
    state.looked_at = nullptr;
    say(context.ui, "This is \"" + state.shown->name + "\", which is in no file yet.");
}

Lesson lesson_to_save(const Workspace& work, const LessonState& state) {
    Lesson lesson = *state.lesson;
    for (LessonStep& step : lesson.steps) {  // an unfinished line is not an option yet
        while (step.question && !step.question->options.empty() &&
               step.question->options.back().empty()) {
            step.question->options.pop_back();
        }
    }
    PatternSet shown = lesson.set;
    give_looks(shown);
    if (shown == work.document.set) return lesson;
    lesson.set = work.document.set;
    lesson.set_name.clear();
    return lesson;
}

void save_lesson_dialog(Ui& ui, Workspace& work, LessonState& state) {
    ask_for_file(
        ui,
        {.use = ChooserUse::save,
         .title = "Save the lesson",
         .extensions = {kLessonEnding},
         .take = [&](const std::filesystem::path& path) { save_lesson(ui, work, state, path); }},
        state.path.empty() ? work.document.path.parent_path() : state.path.parent_path(),
        file_stem(state.lesson->name) + kLessonEnding);
}

bool save_lesson(Ui& ui, Workspace& work, LessonState& state, const std::filesystem::path& path) {
    std::filesystem::path target = std::filesystem::absolute(path);
    if (!is_lesson_file(target)) target += kLessonEnding;
    const Lesson lesson = lesson_to_save(work, state);
    if (const auto written = write_lesson_file(target, lesson); !written) {
        complain(ui, "Not saved: " + written.error().message);
        return false;
    }
    state.path = target;
    state.key = target.string();
    state.is_tour = false;
    note_lesson_saved(work, state);
    (void)keep_lesson(work, state);  // the last autosave is older than the file
    remember_file(work.session, target);
    const std::size_t lacks = lesson_lacks(lesson).size();
    say(ui, lacks == 0 ? "Saved the lesson " + target.string() + "."
                       : "Saved the draft " + target.string() +
                             ". Lesson > Check the lesson tells what it " + "lacks: " +
                             std::to_string(lacks) + (lacks == 1 ? " thing." : " things."));
    return true;
}

void check_lesson(Ui& ui, const Workspace& work, const LessonState& state) {
    if (!state.step) return complain(ui, "Open a lesson first, or begin a new one.");
    constexpr std::size_t kMost = 12;
    const Lesson lesson = lesson_to_save(work, state);
    std::vector<std::string> lacks = lesson_lacks(lesson);
    for (std::string& lack : translation_lacks(lesson)) lacks.push_back(std::move(lack));
    if (lacks.empty()) return say(ui, "The lesson lacks nothing.");
    std::string text = "It can be saved and presented; what is listed here is left out in class.";
    for (std::size_t k = 0; k < std::min(lacks.size(), kMost); ++k) text += "\n" + lacks[k] + ".";
    if (lacks.size() > kMost) text += "\nand " + std::to_string(lacks.size() - kMost) + " more.";
    tell(ui, "What the lesson lacks", text);
}

void save_sheet_dialog(Ui& ui, const Workspace& work, LessonState& state) {
    state.hands_on = false;
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Student sheet of the lesson",
                  .extensions = {".html"},
                  .take = [&](const std::filesystem::path& file) { state.sheet_to = file; }},
                 work.document.path.parent_path(), file_stem(state.shown->name) + ".html");
}

void hand_on_dialog(Ui& ui, const Workspace& work, LessonState& state) {
    const auto file = whole_lesson_file(lesson_to_save(work, state));
    if (!file) return complain(ui, "Not handed on: " + with_stop(file.error().message));
    state.hands_on = true;
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "The lesson, to hand on",
                  .extensions = {".html"},
                  .take = [&](const std::filesystem::path& path) { state.sheet_to = path; }},
                 work.document.path.parent_path(),
                 file_stem(state.shown->name) + " to hand on.html");
}

}  // namespace tact
