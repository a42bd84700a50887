// tactspace lesson: a lesson as text, as a student sheet, or as the program writes it.

#include <iostream>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/lesson/lesson.h"
#include "app/lesson/lesson_sheet.h"
#include "app/window/animation.h"
#include "assets/assets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/recordings/recording.h"
#include "model/lesson/lesson_languages.h"
#include "model/text/atomic_file.h"
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
                           const LessonAnswers& answers) {
    LessonSheet sheet{lesson, answers, {}, std::string("tactspace ") + TACT_VERSION};
    const auto progress = progress_line("drawing steps");
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        sheet.pictures.push_back(step_picture(lesson, k));
        progress(static_cast<double>(k + 1) / static_cast<double>(lesson.steps.size()));
    }
    return write_atomically(path, lesson_sheet(sheet));
}

}  // namespace

Expected<Done> run(const LessonCommand& command) {
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
    return write_sheet(command.out, *lesson, answers);
}

}  // namespace tact
