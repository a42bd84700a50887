#include "app/lesson/lesson.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "assets/assets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_languages.h"

namespace tact {

namespace {

// Recent edits are written to disk before the document is set aside, because it has no autosave
// while the lesson shows its own set.
void keep_on_disk(Workspace& work) {
    wait_for_autosave(work);
    const bool pending = work.autosave_pending || work.unsaved_revision != work.revision;
    if (pending) (void)autosave(work.session, work.document.kept());
    work.autosave_pending = false;
}

// Opens a document without telling the session.
void show_in_place(Ui& ui, Workspace& work, EditedDocument document, std::uint64_t number) {
    work.document = std::move(document);
    work.document_number = number;
    work.changes = {};
    ui.fonts_outdated = true;
    document_changed(work);
}

void put_aside(const LessonContext& context, LessonState& state, const PatternSet& set) {
    Workspace& work = context.work;
    keep_on_disk(work);
    state.aside =
        SetAside{work.document, work.effects, work.selection, work.side, work.document_number};
    PatternSet shown = set;
    give_looks(shown);
    work.effects = {};
    work.selection = {};
    work.side = Side::both;
    EditedDocument own;
    own.open({shown, {}, shown});
    show_in_place(context.ui, work, std::move(own), ++work.documents);
    work.unsaved = false;
    state.document_number = work.document_number;
}

void bring_back(const LessonContext& context, LessonState& state) {
    if (!state.aside) return;
    SetAside aside = *std::exchange(state.aside, std::nullopt);
    Workspace& work = context.work;
    show_in_place(context.ui, work, std::move(aside.document), aside.number);
    work.effects = std::move(aside.effects);
    work.selection = std::move(aside.selection);
    work.side = aside.side;
    work.unsaved_revision = 0;  // look again
}

// Makes room for the card and the step's pane: ends the maximised state of another pane.
void arrange(const LessonContext& context, const LessonState& state, const LessonStep& step) {
    Layout& layout = context.layout;
    layout = state.before.layout;
    const bool map = shows_map(step);
    layout.physiology = Fold::open;
    layout.left = 0.18F;
    layout.right = map ? 0.5F : 0.26F;
    if (map) layout.right_split = 0.72F;
    if (layout.maximised) layout.maximised = map ? Pane::space : Pane::physiology;
}

// A step that asks for a place needs a flat map.
void lay_map(const LessonContext& context, const LessonState& state, const LessonStep& step) {
    const bool flat = step.question && step.question->kind == QuestionKind::place;
    const int wanted = flat ? 2 : state.before.dimensions;
    if (!shows_map(step) || context.shown_map.dimensions == wanted) return;
    context.shown_map.dimensions = wanted;
    document_changed(context.work);
}

// The same lesson if it names no renamed pattern.
std::shared_ptr<const Lesson> with_renamed(const std::shared_ptr<const Lesson>& before,
                                           const Renaming& renaming) {
    Lesson lesson = *before;
    for (LessonStep& step : lesson.steps) {
        follow(renaming, step.pattern);
        follow(renaming, step.partner);
        if (!step.question) continue;
        for (PatternPair& pair : step.question->pairs) {
            follow(renaming, pair.a);
            follow(renaming, pair.b);
        }
    }
    return lesson == *before ? before : std::make_shared<const Lesson>(std::move(lesson));
}

}  // namespace

ViewBeforeLesson view_of(const LessonContext& context) {
    return {context.layout,
            context.work.selection.current,
            context.work.selection.pinned,
            context.timeline.playhead,
            context.timeline.range,
            context.physiology.view.open,
            context.shown_map.camera,
            context.ui.text_scale,
            context.shown_map.dimensions};
}

std::shared_ptr<const Lesson> bundled_lesson(const char* path) {
    auto lesson = parse_lesson(asset(path), path, {});
    assert(lesson && "a lesson that comes with the program does not parse");
    return std::make_shared<const Lesson>(*std::move(lesson));
}

std::optional<Stage> stage_of_view(const std::string& view) { return stage_named(view); }

bool shows_map(const LessonStep& step) { return step.view == "map"; }

const LessonStep* step_of(const LessonState& state) {
    return state.step && state.shown ? &state.shown->steps[*state.step] : nullptr;
}

std::size_t shown_language(const LessonState& state) {
    return state.lesson ? language_place(*state.lesson, state.language) : 0;
}

void show_lesson(LessonState& state, std::shared_ptr<const Lesson> lesson) {
    state.lesson = std::move(lesson);
    state.shown = in_language(state.lesson, shown_language(state));
    state.tallies.resize(state.lesson->steps.size());
}

void choose_language(Ui& ui, LessonState& state, const std::string& code) {
    state.language = code;
    if (state.lesson) show_lesson(state, state.lesson);
    ui.fonts_outdated = true;  // it may need other glyphs
}

void go_to_step(const LessonContext& context, LessonState& state, std::size_t to) {
    if (!state.lesson || state.lesson->steps.empty()) return;
    state.step = std::min(to, state.lesson->steps.size() - 1);
    state.shows_source = false;
    const LessonStep& step = *step_of(state);
    Workspace& work = context.work;
    if (const auto place = place_named(work.document.set, step.pattern)) select_only(work, *place);
    work.selection.pinned = step.partner;
    if (!state.editing) arrange(context, state, step);
    context.physiology.view.open = stage_of_view(step.view);
    context.physiology.view.explained.reset();
    context.timeline.range = {step.from_s, step.to_s};
    const bool moves = step.speed > 0.0;
    context.timeline.playhead = {
        .at_s = step.at_s, .speed = moves ? step.speed : 0.1, .playing = moves, .loop = true};
    if (!state.editing) lay_map(context, state, step);
    if (step.camera) {
        context.shown_map.camera.yaw_rad = step.camera->yaw_rad;
        context.shown_map.camera.pitch_rad = step.camera->pitch_rad;
        context.shown_map.camera.zoom = step.camera->zoom;
    }
}

void start_lesson(const LessonContext& context, LessonState& state,
                  std::shared_ptr<const Lesson> lesson, const std::filesystem::path& path) {
    if (!leave_lesson(context, state)) return;
    state.before = view_of(context);
    put_aside(context, state, lesson->set);
    state.tallies.clear();
    show_lesson(state, std::move(lesson));
    state.path = path;
    state.key = path.string();
    state.is_tour = state.is_of_set = false;
    state.editing = state.is_written = false;
    state.history.clear();
    note_lesson_saved(context.work, state);
    go_to_step(context, state, 0);
}

void start_tour(const LessonContext& context, LessonState& state) {
    start_bundled_lesson(context, state, kTourLesson);
    const auto left = state.left_at.find(state.key);
    if (state.is_tour && left != state.left_at.end()) go_to_step(context, state, left->second);
}

void start_bundled_lesson(const LessonContext& context, LessonState& state, const char* path) {
    const auto lesson = bundled_lesson(path);
    start_lesson(context, state, lesson, {});
    if (state.lesson != lesson) return;  // the previous lesson stays
    state.key = path;
    state.is_tour = state.key == kTourLesson;
}

void ask_where_to_begin(const LessonContext& context, LessonState& state) {
    const auto left = state.left_at.find(state.key);
    if (!state.step || left == state.left_at.end()) return;
    const std::size_t count = state.lesson->steps.size();
    const std::size_t at = left->second;
    if (at >= count) return;
    const std::string step = std::to_string(at + 1);
    ask(context.ui, {.title = "Where to begin",
                     .text = "\"" + state.shown->name + "\" was left at step " + step + " of " +
                             std::to_string(count) + ".",
                     .answers = {{"Continue at step " + step,
                                  [context, &state, at] { go_to_step(context, state, at); }},
                                 {"From the beginning"}},
                     .marked = 1});
}

std::map<std::string, std::size_t> places_left(const LessonState& state) {
    std::map<std::string, std::size_t> places = state.left_at;
    if (!state.step || state.key.empty()) return places;
    const bool has_begun = *state.step > 0;
    const bool finished = *state.step + 1 == state.lesson->steps.size();
    if (has_begun && !finished) {
        places[state.key] = *state.step;
    } else {
        places.erase(state.key);
    }
    return places;
}

void open_lesson(const LessonContext& context, LessonState& state,
                 const std::filesystem::path& path) {
    auto lesson = read_lesson_file(path);
    if (!lesson) return complain(context.ui, lesson.error().message);
    const auto opened = std::make_shared<const Lesson>(*std::move(lesson));
    state.kept_in.clear();
    start_lesson(context, state, opened, std::filesystem::absolute(path));
    if (state.lesson != opened) return;
    ask_where_to_begin(context, state);
    remember_file(context.work.session, state.path);
    std::string text = "Opened the lesson " + opened->name + ".";
    if (!state.kept_in.empty())
        text += " The draft before it is kept in " + state.kept_in.string() + ".";
    say(context.ui, text);
}

bool leave_lesson(const LessonContext& context, LessonState& state) {
    if (!state.step) return true;
    const auto unsaved = unsaved_lesson(context.work, state);
    const bool was_written = state.is_written;  // an author starts at the beginning
    if (state.is_written && !set_lesson_aside(context, state, unsaved)) return false;
    if (!was_written) state.left_at = places_left(state);
    if (state.presenting) state.present_scale = context.ui.text_scale;
    state.step.reset();
    state.presenting = state.blank = state.editing = false;
    const ViewBeforeLesson& before = state.before;
    const bool relaid =
        std::exchange(context.shown_map.dimensions, before.dimensions) != before.dimensions;
    if (relaid && !state.aside) document_changed(context.work);
    bring_back(context, state);
    context.layout = before.layout;
    if (before.current < context.work.document.set.vibrations.size())
        context.work.selection.current = before.current;
    context.work.selection.pinned = before.pinned;
    context.timeline.playhead = before.playhead;
    context.timeline.range = before.time_range;
    context.physiology.view.open = before.open;
    context.shown_map.camera = before.camera;
    if (context.ui.text_scale != before.text_scale) set_text_scale(context.ui, before.text_scale);
    return true;
}

namespace {

// Keeps unsaved changes of the document set aside in a file, as if it had been replaced directly.
void let_go_of_aside(const LessonContext& context, LessonState& state) {
    if (!state.aside) return;
    Workspace& work = context.work;
    std::swap(work.document, state.aside->document);
    const Expected<std::filesystem::path> kept = keep_unsaved(work);
    std::swap(work.document, state.aside->document);
    if (kept && !kept->empty()) {
        say(context.ui, "The lesson ended. Unsaved changes of the set before it are kept in " +
                            kept->string() + ".");
    } else if (!kept) {
        complain(context.ui, kept.error().message);
    }
    state.aside.reset();
}

}  // namespace

void follow_document(const LessonContext& context, LessonState& state) {
    if (!state.step || context.work.document_number == state.document_number) return;
    state.document_number = context.work.document_number;
    // The unsaved version is that of the last frame, with the set that it had then.
    const bool stays = state.unsaved && !set_lesson_aside(context, state, state.unsaved);
    let_go_of_aside(context, state);
    state.before.current = 0;
    state.before.pinned.clear();
    if (stays) return;
    let_lesson_go(state);
    leave_lesson(context, state);
}

void follow_renaming(LessonState& state, const Renaming& renaming) {
    follow(renaming, state.before.pinned);
    if (!state.lesson || !state.step) return;
    std::map<std::shared_ptr<const Lesson>, std::shared_ptr<const Lesson>> renamed;
    const auto of = [&](const std::shared_ptr<const Lesson>& before) {
        auto& after = renamed[before];
        if (!after) after = with_renamed(before, renaming);
        return after;
    };
    state.history.amend(of);  // a name is not an edit of the lesson
    if (const auto renamed_lesson = of(state.lesson); renamed_lesson != state.lesson) {
        show_lesson(state, renamed_lesson);
    }
}

// The numbers of a lesson, computed in the background: quick ones first, then those of pairs.

namespace {

std::optional<LessonAnswered> answer_lesson(const LessonAsked& asked, std::stop_token stop,
                                            std::atomic<float>& progress) {
    LessonAnswered answered{asked.lesson, asked.with_pairs,
                            lesson_answers(*asked.lesson, stop, asked.with_pairs)};
    progress = 1.0F;
    if (stop.stop_requested()) return std::nullopt;
    return answered;
}

}  // namespace

void follow_lesson(const Ui& ui, LessonState& state) {
    if (auto answered = state.job.latest()) state.answered = std::move(answered);
    if (!has_jobs(ui) || !state.shown) return;
    const bool has_quick = state.answered && state.answered->of == state.shown;
    state.job.want(LessonAsked{state.shown, has_quick}, answer_lesson, ui.wake);
}

// Numbers of a lesson that is being edited stay until the new ones are ready.
const LessonAnswers* answers_of(const LessonState& state) {
    if (!state.answered || (state.answered->of != state.shown && !state.editing)) return nullptr;
    return &state.answered->answers;
}

}  // namespace tact
