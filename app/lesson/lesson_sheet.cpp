#include "app/lesson/lesson.h"

#include <algorithm>
#include <array>

#include "app/report/report.h"
#include "model/io/lesson/lesson_file.h"
#include "model/set/layers.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

std::string paragraph(const LessonSheet& sheet, const std::string& text) {
    return "<p class=\"words\">" + html_escaped(filled(text, sheet.answers.numbers)) + "</p>\n";
}

// The sheet's own words.
struct SheetWords {
    const char* language;
    const char* name;
    const char* why;
    const char* mark;
    const char* note;
    const char* answers;
    const char* sources;
};

constexpr auto kSheetWords = std::to_array<SheetWords>(
    {{"en", "Name:", "Why?", "Mark the place in the map. Next to which does it lie?", "Note",
      "Answers", "Sources"},
     {"de", "Name:", "Warum?", "Kreuze die Stelle in der Karte an. Neben welchem Muster liegt sie?",
      "Notiz", "Antworten", "Quellen"},
     {"ko", "\uc774\ub984:", "\uc65c \uadf8\ub807\uc2b5\ub2c8\uae4c?",
      "\uc9c0\ub3c4\uc5d0 \uc704\uce58\ub97c \ud45c\uc2dc\ud558\uc2ed\uc2dc\uc624. \uc5b4\ub290 "
      "\ud328\ud134 \uc606\uc785\ub2c8\uae4c?",
      "\uba54\ubaa8", "\ub2f5", "\ucd9c\ucc98"}});

// English if the lesson's language has no words here.
const SheetWords& words_of(const LessonSheet& sheet) {
    const auto& languages = sheet.lesson.languages;
    const auto* found = std::ranges::find_if(kSheetWords, [&](const SheetWords& words) {
        return !languages.empty() && languages[0] == words.language;
    });
    return found == kSheetWords.end() ? kSheetWords[0] : *found;
}

bool is_handed_on(const LessonSheet& sheet) { return !sheet.lesson_file.empty(); }

QuestionAnswer answer_of_step(const LessonSheet& sheet, std::size_t k) {
    return k < sheet.answers.questions.size() ? sheet.answers.questions[k] : QuestionAnswer{};
}

// `mark` stands before it: the number of its step, or a mark for the answer.
std::string answer_html(const LessonSheet& sheet, std::size_t k, const std::string& mark) {
    const LessonQuestion& question = *sheet.lesson.steps[k].question;
    const QuestionAnswer answer = answer_of_step(sheet, k);
    std::string text;
    for (const std::size_t right : answer.right) {
        text += (text.empty() ? "" : "; ") + answer.options[right];
    }
    text = filled(text.empty() ? "none" : text, sheet.answers.numbers) + ". " +
           filled(question.reveal, sheet.answers.numbers);
    for (const std::string& more : {answer.model, answer.people}) {
        if (!more.empty()) text += " " + more;
    }
    return "<p><b>" + mark + "</b> " + html_escaped(text) + "</p>\n";
}

std::string question_html(const LessonSheet& sheet, std::size_t k) {
    const LessonQuestion& question = *sheet.lesson.steps[k].question;
    std::string html = "<div class=\"question\">" + paragraph(sheet, question.ask);
    if (question.kind == QuestionKind::place) {
        html += std::string("<p>") + words_of(sheet).mark + "</p>\n";
    }
    html += "<ul>\n";
    for (const std::string& option : answer_of_step(sheet, k).options) {
        html += "<li>\u2610 " + html_escaped(filled(option, sheet.answers.numbers)) + "</li>\n";
    }
    html += "</ul>";
    if (is_handed_on(sheet)) return html + answer_html(sheet, k, "\u2713") + "</div>\n";
    return html + "<p class=\"line\">" + words_of(sheet).why + "</p></div>\n";
}

std::string step_html(const LessonSheet& sheet, std::size_t k) {
    const LessonStep& step = sheet.lesson.steps[k];
    std::string html = paragraph(sheet, step.text);
    if (k < sheet.pictures.size() && !sheet.pictures[k].empty()) {
        html += "<figure>" + sheet.pictures[k] + "</figure>\n";
    }
    if (step.question) html += question_html(sheet, k);
    if (is_handed_on(sheet) && !step.note.empty()) {
        html += std::string("<p class=\"note words\"><b>") + words_of(sheet).note + "</b> " +
                html_escaped(filled(step.note, sheet.answers.numbers)) + "</p>\n";
    }
    const std::string heading =
        std::to_string(k + 1) + ". " + filled(step.title, sheet.answers.numbers);
    return html_section("step" + std::to_string(k + 1), heading, html);
}

std::string answers_html(const LessonSheet& sheet) {
    if (is_handed_on(sheet)) return {};  // they stand beside the questions
    std::string html;
    for (std::size_t k = 0; k < sheet.lesson.steps.size(); ++k) {
        if (sheet.lesson.steps[k].question) html += answer_html(sheet, k, std::to_string(k + 1));
    }
    if (html.empty()) return {};
    return "<div class=\"answers\">" + html_section("answers", words_of(sheet).answers, html) +
           "</div>";
}

std::string sources_html(const LessonSheet& sheet) {
    std::vector<std::string> sources;
    for (const LessonStep& step : sheet.lesson.steps) {
        const std::string source = source_for_class(step);
        const bool known = std::ranges::find(sources, source) != sources.end();
        if (!source.empty() && !known) sources.push_back(source);
    }
    std::string html;
    for (const std::string& source : sources) html += "<li>" + html_escaped(source) + "</li>\n";
    if (html.empty()) return {};
    return html_section("sources", words_of(sheet).sources, "<ul>" + html + "</ul>");
}

// A click saves the lesson file: the page needs no network and runs no script.
std::string lesson_link(const LessonSheet& sheet) {
    if (!is_handed_on(sheet)) return {};
    const std::string name = file_stem(sheet.lesson.name) + kLessonEnding;
    return "<p class=\"screen\"><a download=\"" + html_escaped(name) +
           "\" href=\"data:application/json;base64," + base64(sheet.lesson_file) +
           "\">Save the lesson</a>, with its set, notes and languages, and open it in tactspace: "
           "Lesson &gt; Open lesson.</p>";
}

}  // namespace

Expected<std::string> whole_lesson_file(Lesson lesson) {
    for (const Vibration& vibration : lesson.set.vibrations) {
        if (recordings_in(vibration).empty()) continue;
        return Error{in_quotes(vibration.name) +
                     " is a recording, and a lesson file has the name of its file alone: hand on "
                     "the folder of both, or a lesson without recordings"};
    }
    lesson.set_name.clear();
    return print_lesson(lesson, {});
}

std::string lesson_sheet(const LessonSheet& sheet) {
    HtmlPage page;
    page.title = sheet.lesson.name;
    if (!sheet.lesson.languages.empty()) page.language = sheet.lesson.languages[0];
    page.lead = "<p>" + html_escaped(sheet.lesson.about) +
                (is_handed_on(sheet)
                     ? ""
                     : std::string(" ") + words_of(sheet).name + " <span class=\"name\"></span>") +
                "</p>" + lesson_link(sheet) +
                "<p class=\"screen\">Ctrl+P prints it, to paper or to a PDF: no picture and no "
                "question is torn.</p>";
    for (std::size_t k = 0; k < sheet.lesson.steps.size(); ++k) page.body += step_html(sheet, k);
    page.body += answers_html(sheet) + sources_html(sheet);
    page.foot = "<p>" + html_escaped(sheet.program) +
                ". Every number is the model's (Lim &amp; Park 2023), on the patterns of this "
                "lesson.</p>";
    page.style =
        "figure{margin:0.5em 0;break-inside:avoid}figure svg{width:100%;height:auto}"
        ".question{border-left:3px solid var(--accent);padding-left:1em;break-inside:avoid}"
        ".question ul,.question li{list-style:none}"
        ".line{border-bottom:1px solid var(--line);min-height:3em}"
        ".name{display:inline-block;width:16em;border-bottom:1px solid var(--line)}"
        ".answers{break-before:page}.words{white-space:pre-line}p.words:not(.note){break-after:"
        "avoid}"
        ".note{border-left:3px solid var(--line);padding-left:1em;color:var(--dim-text)}";
    return html_of(page);
}

}  // namespace tact
