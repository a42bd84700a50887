// What a lesson that is being written still lacks before a class can see it.
//
// Output    sentences without their stop, in the order of the steps; none: it is whole
#pragma once

#include <string>
#include <vector>

#include "model/lesson/lesson.h"

namespace tact {

// Patterns that the set has not, numbers that the model cannot give, questions without an answer.
std::vector<std::string> step_lacks(const LessonStep& step, const PatternSet& set);

// The same of all steps, each with the step that it is about.
std::vector<std::string> lesson_lacks(const Lesson& lesson);

// The set has every pattern that the step names.
bool has_its_patterns(const LessonStep& step, const PatternSet& set);

// The step's question can be asked: it needs nothing, and the set has every pattern that it names.
bool is_question_whole(const LessonStep& step, const PatternSet& set);

}  // namespace tact
