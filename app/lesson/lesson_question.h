// Predict, then reveal: a question of a step, the class's votes by number keys, the answer.
//
// Output    right, where most votes are among the model's answers
#pragma once

#include <optional>
#include <string>
#include <vector>

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

// What is asked, in words with their numbers: for those who answer on devices of their own.
struct QuestionInWords {
    std::string ask;
    std::vector<std::string> options;
    bool is_revealed = false;
    std::vector<std::size_t> right;
    std::string reveal;  // what is said with the answer
};
// None: nothing is asked, or the model is on its way.
std::optional<QuestionInWords> question_in_words(const LessonState& state);

// Votes of the step's question that did not come by hands, all of them: they are counted besides.
void count_elsewhere(LessonState& state, const std::vector<int>& votes);

struct LessonScore {
    int asked = 0;  // and revealed, with votes
    int right = 0;
};

LessonScore score_of(const LessonState& state);

}  // namespace tact
