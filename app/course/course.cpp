#include <algorithm>
#include <utility>

#include "app/course/course.h"
#include "app/lesson/lesson.h"
#include "app/session/session.h"
#include "assets/assets.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/text/atomic_file.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

constexpr const char* kBundledCourse = "courses/touch.tactcourse.json";

std::string bundled_path(const std::string& name) { return "lessons/" + name + kLessonEnding; }

bool is_bundled(const std::string& name) {
    return std::ranges::any_of(assets(),
                               [&](const Asset& file) { return file.path == bundled_path(name); });
}

CourseLesson lesson_of(const std::string& name, const fs::path& folder) {
    CourseLesson result;
    if (is_bundled(name)) {
        result.key = bundled_path(name);
        result.lesson = bundled_lesson(result.key.c_str());
        return result;
    }
    result.path = folder / name;
    result.key = result.path.string();
    Expected<Lesson> lesson = read_lesson_file(result.path);
    if (lesson) {
        result.lesson = std::make_shared<const Lesson>(*std::move(lesson));
    } else {
        result.fault = lesson.error().message;
    }
    return result;
}

void read_once(Ui& ui, const Session& session, CourseState& state) {
    if (std::exchange(state.is_read, true)) return;
    const fs::path file = progress_file(session);
    if (file.empty()) {
        state.fault = "there is no folder to keep it in";
        return;
    }
    if (!is_there(file)) return;
    auto read = read_progress(file);
    if (read) {
        state.progress = *std::move(read);
    } else {
        state.fault = read.error().message;
        complain(ui, "What students did before could not be read, and nothing more is kept: " +
                         state.fault);
    }
}

// What was chosen by most hands, which are the student's own; none: nothing was.
std::optional<std::size_t> chosen(const Tally& tally) {
    const auto most = std::ranges::max_element(tally.votes);
    if (*most == 0) return std::nullopt;
    return static_cast<std::size_t>(most - tally.votes.begin());
}

void note_answers(const LessonState& lesson, LessonProgress& progress) {
    const LessonAnswers* answers = answers_of(lesson);
    if (answers == nullptr) return;
    for (std::size_t k = 0; k < lesson.tallies.size(); ++k) {
        const auto option = chosen(lesson.tallies[k]);
        if (!lesson.tallies[k].revealed || !option || progress.answers.contains(k)) continue;
        if (k >= answers->questions.size() || !lesson.shown->steps[k].question) continue;
        const QuestionAnswer& asked = answers->questions[k];
        if (*option >= asked.options.size()) continue;
        const auto text = [&](const std::string& one) { return filled(one, answers->numbers); };
        const bool right = std::ranges::find(asked.right, *option) != asked.right.end();
        progress.answers[k] = {text(lesson.shown->steps[k].question->ask),
                               text(asked.options[*option]), right, utc_now()};
    }
}

bool is_of_course(const CourseState& state, const std::string& key) {
    return state.course &&
           std::ranges::find(state.lessons, key, &CourseLesson::key) != state.lessons.end();
}

}  // namespace

fs::path progress_file(const Session& session) {
    return session.folder.empty() ? fs::path{} : session.folder / "students.json";
}

Expected<ClassProgress> read_progress(const fs::path& file) {
    const auto text = read_text_file(file);
    if (!text) return text.error();
    return parse_progress(*text, file.string());
}

void open_course(Ui& ui, const Session& session, CourseState& state, const Course& course,
                 const fs::path& folder) {
    read_once(ui, session, state);
    state.course = course;
    state.lessons.clear();
    for (const std::string& name : course.lessons) state.lessons.push_back(lesson_of(name, folder));
    ui.dialog = kCourseDialog;
}

void open_course_file(Ui& ui, Session& session, CourseState& state, const fs::path& path) {
    const auto course = read_course_file(path);
    if (!course) return complain(ui, course.error().message);
    const fs::path whole = fs::absolute(path);
    open_course(ui, session, state, *course, whole.parent_path());
    remember_file(session, whole);
}

void open_bundled_course(Ui& ui, const Session& session, CourseState& state) {
    const auto course = parse_course(asset(kBundledCourse), kBundledCourse);
    if (!course) return complain(ui, course.error().message);
    open_course(ui, session, state, *course, {});
}

std::optional<std::size_t> next_lesson(const CourseState& state) {
    for (std::size_t k = 0; k < state.lessons.size(); ++k) {
        const LessonProgress* progress = progress_of(state, state.lessons[k]);
        const bool is_done = progress != nullptr && progress->reached >= progress->steps;
        if (state.lessons[k].lesson && !is_done) return k;
    }
    return std::nullopt;
}

void begin_course_lesson(const LessonContext& context, LessonState& lesson, CourseState& state,
                         std::size_t which) {
    const CourseLesson& one = state.lessons[which];
    if (!one.lesson) return complain(context.ui, one.fault);
    const LessonProgress* progress = progress_of(state, one);
    start_lesson(context, lesson, one.lesson, one.path);
    if (lesson.lesson != one.lesson) return;  // the one before it stays
    lesson.key = one.key;
    lesson.is_tour = one.key == kTourLesson;
    state.has_begun = true;
    if (progress == nullptr || progress->reached >= progress->steps) return;
    if (progress->reached > 1) go_to_step(context, lesson, progress->reached - 1);
}

void follow_course(Ui& ui, const Session& session, const LessonState& lesson, CourseState& state) {
    const std::string key = lesson.step ? lesson.key : std::string();
    const std::string last = std::exchange(state.last_key, key);
    const bool has_ended = key.empty() && is_of_course(state, last);
    const bool returns = has_ended && std::exchange(state.has_begun, false);
    if (returns && ui.dialog == kNoDialog && !ui.question) ui.dialog = kCourseDialog;
    const bool counts = is_of_course(state, key) && !lesson.presenting && !lesson.editing;
    if (!counts || state.student.empty() || !state.fault.empty()) return;
    LessonProgress& progress = state.progress[state.student][key];
    const LessonProgress before = progress;
    progress.steps = lesson.lesson->steps.size();
    progress.reached = std::min(progress.steps, std::max(progress.reached, *lesson.step + 1));
    note_answers(lesson, progress);
    if (progress == before) return;
    const auto written =
        write_atomically(progress_file(session), print_progress(state.progress), kPrivateFile);
    if (written) return;
    state.fault = written.error().message;
    complain(ui, "What " + state.student + " does is not kept: " + state.fault);
}

CourseScore score_of(const LessonProgress& progress) {
    const auto right = std::ranges::count_if(
        progress.answers, [](const auto& answer) { return answer.second.right; });
    return {static_cast<std::size_t>(right), progress.answers.size()};
}

const LessonProgress* progress_of(const CourseState& state, const CourseLesson& lesson) {
    const auto student = state.progress.find(state.student);
    if (state.student.empty() || student == state.progress.end()) return nullptr;
    const auto found = student->second.find(lesson.key);
    return found == student->second.end() ? nullptr : &found->second;
}

void export_answers(Ui& ui, const CourseState& state, const fs::path& file) {
    const auto written = write_atomically(file, answers_csv(state.progress));
    if (!written) return complain(ui, "Not written: " + written.error().message);
    say(ui, "Wrote the answers of the class, " + file.string() + ".");
}

}  // namespace tact
