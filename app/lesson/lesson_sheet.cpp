#include "app/lesson/lesson_sheet.h"

#include <algorithm>

#include "app/report/html.h"

namespace tact {

namespace {

std::string paragraph(const LessonSheet& sheet, const std::string& text) {
    return "<p>" + html_escaped(filled(text, sheet.answers.numbers)) + "</p>\n";
}

QuestionAnswer answer_of_step(const LessonSheet& sheet, std::size_t k) {
    return k < sheet.answers.questions.size() ? sheet.answers.questions[k] : QuestionAnswer{};
}

std::string question_html(const LessonSheet& sheet, std::size_t k) {
    const LessonQuestion& question = *sheet.lesson.steps[k].question;
    std::string html = "<div class=\"question\">" + paragraph(sheet, question.ask);
    if (question.kind == QuestionKind::place) {
        html += "<p>Mark the place in the map. Next to which does it lie?</p>\n";
    }
    html += "<ul>\n";
    for (const std::string& option : answer_of_step(sheet, k).options) {
        html += "<li>\u2610 " + html_escaped(filled(option, sheet.answers.numbers)) + "</li>\n";
    }
    return html + "</ul><p class=\"line\">Why?</p></div>\n";
}

std::string step_html(const LessonSheet& sheet, std::size_t k) {
    const LessonStep& step = sheet.lesson.steps[k];
    std::string html = paragraph(sheet, step.text);
    if (k < sheet.pictures.size() && !sheet.pictures[k].empty()) {
        html += "<figure>" + sheet.pictures[k] + "</figure>\n";
    }
    if (step.question) html += question_html(sheet, k);
    const std::string heading =
        std::to_string(k + 1) + ". " + filled(step.title, sheet.answers.numbers);
    return html_section("step" + std::to_string(k + 1), heading, html);
}

std::string answer_html(const LessonSheet& sheet, std::size_t k) {
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
    return "<p><b>" + std::to_string(k + 1) + "</b> " + html_escaped(text) + "</p>\n";
}

std::string answers_html(const LessonSheet& sheet) {
    std::string html;
    for (std::size_t k = 0; k < sheet.lesson.steps.size(); ++k) {
        if (sheet.lesson.steps[k].question) html += answer_html(sheet, k);
    }
    if (html.empty()) return {};
    return "<div class=\"answers\">" + html_section("answers", "Answers", html) + "</div>";
}

std::string sources_html(const LessonSheet& sheet) {
    std::vector<std::string> sources;
    for (const LessonStep& step : sheet.lesson.steps) {
        const bool known = std::ranges::find(sources, step.source) != sources.end();
        if (!step.source.empty() && !known) sources.push_back(step.source);
    }
    std::string html;
    for (const std::string& source : sources) html += "<li>" + html_escaped(source) + "</li>\n";
    if (html.empty()) return {};
    return html_section("sources", "Sources", "<ul>" + html + "</ul>");
}

}  // namespace

std::string lesson_sheet(const LessonSheet& sheet) {
    HtmlPage page;
    page.title = sheet.lesson.name;
    if (!sheet.lesson.languages.empty()) page.language = sheet.lesson.languages[0];
    page.lead =
        "<p>" + html_escaped(sheet.lesson.about) + " Name: <span class=\"name\"></span></p>";
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
        ".answers{break-before:page}";
    return html_of(page);
}

}  // namespace tact
