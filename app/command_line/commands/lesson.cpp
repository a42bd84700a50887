// tactspace lesson: a lesson as text, as a student sheet, or as the program writes it.

#include <algorithm>
#include <iostream>
#include <optional>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/course/course.h"
#include "app/lesson/lesson.h"
#include "app/window/window.h"
#include "assets/assets.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/recordings/recording.h"
#include "model/lesson/lesson_languages.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// A file, or the name of one that comes with the program.
Expected<Lesson> lesson_named(const std::string& name) {
    const std::string bundled = "lessons/" + name + kLessonEnding;
    for (const Asset& file : assets()) {
        if (file.path == bundled) return parse_lesson(file.text, bundled, {});
    }
    return read_lesson_file(name);
}

// All of it where no language is asked for.
Expected<Lesson> lesson_in(const Lesson& lesson, const std::string& language) {
    if (language.empty()) return lesson;
    const std::size_t place = language_place(lesson, language);
    if (place < lesson.languages.size() && lesson.languages[place] == language) {
        return *in_language(std::make_shared<const Lesson>(lesson), place);
    }
    std::string codes;
    for (const std::string& code : lesson.languages) codes += (codes.empty() ? "" : ", ") + code;
    return Error{"--language: expected " +
                 (codes.empty() ? "nothing, as the lesson names no language" : "one of " + codes) +
                 ", got " + in_quotes(language)};
}

void print_question(const LessonQuestion& question, const QuestionAnswer& answer,
                    const LessonNumbers& numbers) {
    std::cout << "   Question: " << shown_lines(filled(question.ask, numbers)) << "\n";
    for (std::size_t k = 0; k < answer.options.size(); ++k) {
        const bool right = std::ranges::find(answer.right, k) != answer.right.end();
        std::cout << "     " << k + 1 << " " << shown_text(filled(answer.options[k], numbers))
                  << (right ? "  (right)" : "") << "\n";
    }
    for (const std::string& text :
         {filled(question.reveal, numbers), answer.model, answer.people}) {
        if (!text.empty()) std::cout << "     " << shown_lines(text) << "\n";
    }
}

void print_lesson_text(const Lesson& lesson, const LessonAnswers& answers) {
    std::cout << shown_text(lesson.name) << "\n" << shown_lines(lesson.about) << "\n";
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        const LessonStep& step = lesson.steps[k];
        std::cout << "\n"
                  << k + 1 << ". " << shown_text(filled(step.title, answers.numbers)) << "\n   "
                  << shown_lines(filled(step.text, answers.numbers)) << "\n";
        if (!step.note.empty()) {
            std::cout << "   Note: " << shown_lines(filled(step.note, answers.numbers)) << "\n";
        }
        if (step.question) print_question(*step.question, answers.questions[k], answers.numbers);
        if (!step.source.empty()) std::cout << "   Source: " << shown_text(step.source) << "\n";
    }
}

Expected<Done> write_sheet(const std::filesystem::path& path, const Lesson& lesson,
                           const LessonAnswers& answers, const std::string& lesson_file) {
    LessonSheet sheet{lesson, answers, {}, std::string("tactspace ") + TACT_VERSION, lesson_file};
    const auto progress = progress_line("drawing steps");
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        sheet.pictures.push_back(step_picture(lesson, k));
        progress(static_cast<double>(k + 1) / static_cast<double>(lesson.steps.size()));
    }
    return write_atomically(path, lesson_sheet(sheet));
}

// A file, or the one that comes with the program; none: it is a lesson.
std::optional<Expected<Course>> course_named(const std::string& name) {
    const std::string bundled = "courses/" + name + kCourseEnding;
    for (const Asset& file : assets()) {
        if (file.path == bundled) return parse_course(file.text, bundled);
    }
    if (!is_course_file(name)) return std::nullopt;
    return read_course_file(name);
}

bool is_lesson(const std::string& key, const std::string& lesson) {
    const std::string file = std::filesystem::path(key).filename().string();
    const std::string own = std::filesystem::path(lesson).filename().string();
    return file == own || file == own + kLessonEnding;
}

// Writes what students answered in these lessons alone.
Expected<Done> write_answers(const LessonCommand& command,
                             const std::vector<std::string>& lessons) {
    const auto file = state_folder() / "students.json";
    auto all = read_progress(file);
    if (!all) return all.error();
    for (auto& [student, own] : *all) {
        std::erase_if(own, [&](const auto& one) {
            return std::ranges::none_of(
                lessons, [&](const std::string& lesson) { return is_lesson(one.first, lesson); });
        });
    }
    return write_atomically(command.answers, answers_csv(*all));
}

Expected<Done> run_course(const Expected<Course>& course, const LessonCommand& command) {
    if (!course) return course.error();
    if (!command.answers.empty()) return write_answers(command, course->lessons);
    if (!command.out.empty() || !command.language.empty() || command.hand_on) {
        return Error{command.lesson +
                     ": expected a lesson for --out, --language and --hand-on, "
                     "got a course"};
    }
    std::cout << shown_text(course->name) << "\n" << shown_lines(course->about) << "\n\n";
    const auto folder = std::filesystem::path(command.lesson).parent_path();
    for (std::size_t k = 0; k < course->lessons.size(); ++k) {
        const std::string& name = course->lessons[k];
        const auto lesson =
            is_lesson_file(name) ? read_lesson_file(folder / name) : lesson_named(name);
        std::cout << k + 1 << ". "
                  << (lesson ? shown_text(lesson->name) + ", " +
                                   counted(lesson->steps.size(), "step", "steps")
                             : lesson.error().message)
                  << "\n";
    }
    return Done{};
}

}  // namespace

Expected<Done> run(const LessonCommand& command) {
    if (const auto course = course_named(command.lesson)) return run_course(*course, command);
    if (!command.answers.empty()) return write_answers(command, {command.lesson});
    const Expected<Lesson> whole = lesson_named(command.lesson);
    if (!whole) return whole.error();
    const Expected<Lesson> lesson = lesson_in(*whole, command.language);
    if (!lesson) return lesson.error();
    if (is_lesson_file(command.out)) return write_lesson_file(command.out, *lesson);
    const LessonAnswers answers = lesson_answers(*lesson);
    if (command.out.empty()) {
        print_lesson_text(*lesson, answers);
        return Done{};
    }
    if (extension_of(command.out) != ".html") {
        return Error{command.out.string() + ": expected a name ending in .html, or in " +
                     kLessonEnding};
    }
    if (!command.hand_on) return write_sheet(command.out, *lesson, answers, {});
    const Expected<std::string> file = whole_lesson_file(*whole);
    if (!file) return file.error();
    return write_sheet(command.out, *lesson, answers, *file);
}

}  // namespace tact
