// Predict, then reveal: a question of a step, the class's votes by number keys, the answer.
//
// Output    right, where most votes are among the model's answers
#pragma once

#include "app/lesson/lesson.h"

namespace tact {

// What the step asks; null: nothing, or what cannot be answered yet, which only who writes it sees.
const LessonQuestion* question_of(const LessonState& state);

// The step asks something, and the answer is not on screen yet.
bool hides_answer(const LessonState& state);

void draw_lesson_question(const LessonHands& hands, LessonState& state,
                          const LessonQuestion& question);

// A vote for an option, from 0; too late once the answer is seen. False: there is none such.
bool vote(LessonState& state, std::size_t option);

struct LessonScore {
    int asked = 0;  // and revealed, with votes
    int right = 0;
};

LessonScore score_of(const LessonState& state);

}  // namespace tact
