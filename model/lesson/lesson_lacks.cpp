#include "model/lesson/lesson_lacks.h"

#include "model/lesson/lesson_numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

std::vector<std::string> missing_patterns(const LessonStep& step, const PatternSet& set) {
    std::vector<std::string> names{step.pattern, step.partner};
    if (step.question) {
        for (const PatternPair& pair : step.question->pairs) {
            names.push_back(pair.a);
            names.push_back(pair.b);
        }
    }
    std::erase_if(names, [&](const std::string& name) {
        return name.empty() || place_named(set, name).has_value();
    });
    return names;
}

}  // namespace

bool has_its_patterns(const LessonStep& step, const PatternSet& set) {
    return missing_patterns(step, set).empty();
}

bool is_question_whole(const LessonStep& step, const PatternSet& set) {
    return question_needs(step, set.vibrations.size()).empty() &&
           missing_patterns(step, set).empty();
}

std::vector<std::string> step_lacks(const LessonStep& step, const PatternSet& set) {
    std::vector<std::string> lacks;
    for (const std::string& name : missing_patterns(step, set)) {
        lacks.push_back("The set has no pattern " + in_quotes(name));
    }
    for (const std::string& text : texts_of(step)) {
        for (const std::string& placeholder : placeholders_in(text)) {
            const std::string fault = placeholder_fault(placeholder, set);
            if (!fault.empty()) lacks.push_back("{" + placeholder + "}: " + fault);
        }
    }
    const std::string needed = question_needs(step, set.vibrations.size());
    if (!needed.empty()) lacks.push_back("The question needs " + needed);
    return lacks;
}

std::vector<std::string> lesson_lacks(const Lesson& lesson) {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
        const std::string step =
            "Step " + std::to_string(k + 1) + ", " + in_quotes(lesson.steps[k].title) + ": ";
        for (std::string& lack : step_lacks(lesson.steps[k], lesson.set))
            all.push_back(step + lack);
    }
    return all;
}

}  // namespace tact
