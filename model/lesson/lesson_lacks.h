// The missing parts of a lesson, without which a class cannot see it.
//
// Output    sentences without full stop, in the order of the steps; empty: it is complete
#pragma once

#include <string>
#include <vector>

#include "model/lesson/lesson.h"

namespace tact {

// Patterns missing in the set, numbers that the model cannot compute, questions without an answer.
std::vector<std::string> step_lacks(const LessonStep& step, const PatternSet& set);

// The same for all steps, each with the number of its step.
std::vector<std::string> lesson_lacks(const Lesson& lesson);

// Whether the set has every pattern that the step names.
bool has_its_patterns(const LessonStep& step, const PatternSet& set);

// Whether the step's question can be asked: it is complete, and the set has every pattern that it
// names.
bool is_question_whole(const LessonStep& step, const PatternSet& set);

}  // namespace tact
