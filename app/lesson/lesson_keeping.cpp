#include "app/lesson/lesson.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/common/expected.h"
#include "model/io/lesson/lesson_file.h"

namespace tact {

namespace {

constexpr double kRestS = 0.6;  // the same delay as the document's
constexpr double kMostUnkeptS = 1.0;

bool differ_beside_set(const Lesson& a, const Lesson& b) {
    return a.name != b.name || a.about != b.about || a.steps != b.steps ||
           a.unknown_json != b.unknown_json;
}

std::optional<LessonDraft> draft_of(const LessonState& state,
                                    const std::shared_ptr<const Lesson>& unsaved) {
    if (!unsaved) return std::nullopt;
    return LessonDraft{*unsaved, state.path, state.step.value_or(0)};
}

// Returns the error of writing the autosave, or an empty text.
std::string fault_of(const Session& session, const std::optional<LessonDraft>& draft) {
    try {
        const Expected<Done> written = autosave_lesson(session, draft);
        return written ? std::string() : written.error().message;
    } catch (...) {
        return thrown_error().message;
    }
}

void tell_if_unkept(Ui& ui, LessonState& state, const std::string& fault) {
    if (!fault.empty() && fault != state.autosave_error) {
        complain(ui, "The lesson cannot be kept aside, save it: " + fault);
    }
    state.autosave_error = fault;
}

void wait_for_keeping(LessonState& state) {
    if (state.autosave_write.valid()) (void)state.autosave_write.get();
}

// The set as a file would give it, without the places of its map, which belong to no pattern.
PatternSet bare(PatternSet set) {
    give_looks(set);
    set.map_places = {};
    return set;
}

// The lesson in this file, or an empty lesson.
std::shared_ptr<const Lesson> lesson_in(const std::filesystem::path& path) {
    Expected<Lesson> lesson = path.empty() ? Error{"no file"} : read_lesson_file(path);
    return std::make_shared<const Lesson>(lesson ? *std::move(lesson) : Lesson{});
}

}  // namespace

std::shared_ptr<const Lesson> unsaved_lesson(const Workspace& work, const LessonState& state) {
    if (!state.step || !state.saved || !state.is_written) return nullptr;
    Lesson now = lesson_to_save(work, state);
    const bool is_of_document = !state.aside && state.path.empty();
    const bool same_set = is_of_document || bare(now.set) == bare(state.saved->set);
    if (same_set && !differ_beside_set(now, *state.saved)) return nullptr;
    return std::make_shared<const Lesson>(std::move(now));
}

void note_lesson_saved(const Workspace& work, LessonState& state) {
    state.saved = std::make_shared<const Lesson>(lesson_to_save(work, state));
    state.looked_at = nullptr;
}

void autosave_lesson_if_due(Ui& ui, Workspace& work, LessonState& state) {
    const bool is_under_way = state.step && state.is_written;
    const auto shown = is_under_way ? state.lesson : nullptr;
    if (shown != state.looked_at || (shown && state.looked_revision != work.revision)) {
        state.looked_at = shown;
        state.looked_revision = work.revision;
        state.unsaved = unsaved_lesson(work, state);
        if (!state.keep_pending) state.unkept_since_s = ui.time_s;
        state.keep_due_s = std::min(ui.time_s + kRestS, state.unkept_since_s + kMostUnkeptS);
        state.keep_pending = true;
    }
    if (has_ended(state.autosave_write)) tell_if_unkept(ui, state, state.autosave_write.get());
    if (!state.keep_pending || ui.time_s < state.keep_due_s || is_autosaving(state)) return;
    state.keep_pending = false;
    Session place;  // without the locks, which the program holds
    place.folder = work.session.folder;
    place.autosave = work.session.autosave;
    state.autosave_write =
        begun_beside([place = std::move(place), draft = draft_of(state, state.unsaved)] {
            return fault_of(place, draft);
        });
}

bool is_autosaving(const LessonState& state) { return state.autosave_write.valid(); }

Expected<Done> keep_lesson(const Workspace& work, LessonState& state) {
    wait_for_keeping(state);
    state.keep_pending = false;
    return autosave_lesson(work.session, draft_of(state, unsaved_lesson(work, state)));
}

void let_lesson_go(LessonState& state) {
    state.is_written = false;
    state.unsaved = nullptr;
}

bool set_lesson_aside(const LessonContext& context, LessonState& state,
                      const std::shared_ptr<const Lesson>& unsaved) {
    wait_for_keeping(state);
    state.kept_in.clear();
    Session& session = context.work.session;
    std::string fault = fault_of(session, draft_of(state, unsaved));
    if (unsaved && fault.empty()) {
        const auto file = set_lesson_aside(session, lesson_autosave(session.autosave));
        if (file) {
            state.kept_in = *file;
        } else {
            fault = file.error().message;
        }
    }
    if (unsaved && !fault.empty()) {
        complain(context.ui,
                 "This lesson stays open: what was written cannot be kept aside. Save it first, "
                 "with Lesson > Save lesson as... " +
                     with_stop(fault));
        return false;
    }
    let_lesson_go(state);
    if (unsaved) {
        say(context.ui, "The draft of the lesson is kept in " + state.kept_in.string() +
                            ", the first of File > Open recent.");
    }
    return true;
}

void before_lesson_goes(const LessonContext& context, LessonState& state,
                        std::function<void()> then) {
    if (!unsaved_lesson(context.work, state)) return then();
    // Runs between the panels and the end of the frame: another set may replace the document.
    const auto later = [context, then = std::move(then)] { context.ui.waiting.push_back(then); };
    Answer save{"Save as...",
                [context, &state] { save_lesson_dialog(context.ui, context.work, state); }};
    if (!state.path.empty()) {
        save = {"Save", [context, &state, later] {
                    if (save_lesson(context.ui, context.work, state, state.path)) later();
                }};
    }
    ask(context.ui, {.title = "Unsaved lesson",
                     .text = "What was written in \"" + state.lesson->name +
                             "\" is in no file yet. A draft of it is kept among the recent files.",
                     .answers = {save, {"Keep a draft", later}, {"Cancel"}}});
}

void resume_lesson(const LessonContext& context, LessonState& state, LessonDraft draft) {
    give_looks(draft.lesson.set);
    const bool is_of_document = bare(draft.lesson.set) == bare(context.work.document.set);
    auto lesson = std::make_shared<const Lesson>(std::move(draft.lesson));
    if (is_of_document && draft.path.empty()) {
        write_on_document(context, state, std::move(lesson));
    } else {
        start_lesson(context, state, std::move(lesson), draft.path);
        state.editing = state.is_written = true;
    }
    state.saved = lesson_in(draft.path);
    go_to_step(context, state, draft.step);
}

}  // namespace tact
