#include "model/lesson/lesson.h"

namespace tact {

std::vector<std::string> texts_of(const LessonStep& step) {
    std::vector<std::string> texts{step.title, step.text, step.note};
    if (!step.question) return texts;
    texts.push_back(step.question->ask);
    texts.insert(texts.end(), step.question->options.begin(), step.question->options.end());
    texts.push_back(step.question->reveal);
    return texts;
}

}  // namespace tact
