// Predict, then reveal: a question of a step, the class's votes by number keys, the answer.
//
// Output    right if an answer of the model has the most votes
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/lesson/lesson.h"

namespace tact {

// The question of the step; null if it has none, or one that cannot be answered yet, which only the
// editor shows.
const LessonQuestion* question_of(const LessonState& state);

// Whether the step has a question whose answer is still hidden.
bool hides_answer(const LessonState& state);

void draw_lesson_question(const LessonContext& context, LessonState& state,
                          const LessonQuestion& question);

// Adds a vote for an option, from 0; ignored once the answer is revealed. False: the option does
// not exist.
bool vote(LessonState& state, std::size_t option);

// The question in words with numbers, for people who answer on their own devices.
struct QuestionInWords {
    std::string ask;
    std::vector<std::string> options;
    bool is_revealed = false;
    std::vector<std::size_t> right;
    std::string reveal;  // part of the answer
};
// Nullopt without a question, or while the model still computes its answer.
std::optional<QuestionInWords> question_in_words(const LessonState& state);

// All votes from phones for the step's question; they count in addition to hands.
void count_elsewhere(LessonState& state, const std::vector<int>& votes);

struct LessonScore {
    int asked = 0;  // revealed, with votes
    int right = 0;
};

LessonScore score_of(const LessonState& state);

}  // namespace tact
