#include "model/lesson/lesson.h"

#include <string_view>

#include "model/text/numbers.h"

namespace tact {

std::string question_needs(const LessonStep& step, std::size_t patterns) {
    if (!step.question) return {};
    const LessonQuestion& question = *step.question;
    switch (question.kind) {
        case QuestionKind::choice:
            return question.options.size() < 2
                       ? "at least 2 \"options\" of a question of kind \"choice\""
                       : "";
        case QuestionKind::closest:
        case QuestionKind::farthest:
            return question.pairs.size() < 2 ? "at least 2 \"pairs\" of patterns to choose from"
                                             : "";
        case QuestionKind::place:
            if (step.view != "map") return "the \"view\" \"map\" in the step of this question";
            if (patterns < limits::kLeastPlaced) {
                return "a set of at least 4 patterns for a question of kind \"place\"";
            }
            break;
        case QuestionKind::receptors:
            break;
    }
    return step.pattern.empty() ? "a \"pattern\" in the step of this question" : "";
}

std::string source_for_class(const LessonStep& step) {
    std::string kept;
    std::string_view rest = step.source;
    while (!rest.empty()) {
        const std::size_t end = rest.find(';');
        const std::string_view part = trimmed(rest.substr(0, end));
        if (part.find("not looked up") == std::string_view::npos && !part.empty()) {
            kept += (kept.empty() ? "" : "; ") + std::string(part);
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return kept;
}

std::vector<std::string> texts_of(const LessonStep& step) {
    std::vector<std::string> texts{step.title, step.text, step.note};
    const auto add_question = [&texts](const std::string& ask,
                                       const std::vector<std::string>& options,
                                       const std::string& reveal) {
        texts.push_back(ask);
        texts.insert(texts.end(), options.begin(), options.end());
        texts.push_back(reveal);
    };
    const auto& question = step.question;
    if (question) add_question(question->ask, question->options, question->reveal);
    for (const StepWords& words : step.words) {
        texts.insert(texts.end(), {words.title, words.text, words.note});
        if (question) add_question(words.ask, words.options, words.reveal);
    }
    return texts;
}

}  // namespace tact
