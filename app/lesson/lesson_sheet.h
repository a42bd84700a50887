// A lesson on paper: what students take home or fill in, as one page that stands alone.
//
// Input     the lesson, its numbers and answers, a picture of each step
// Output    HTML (app/report/html.h): steps with pictures and texts, questions with room for an
//           answer, the answers on a page of their own, the sources
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "model/lesson/lesson_numbers.h"

namespace tact {

struct LessonSheet {
    const Lesson& lesson;
    const LessonAnswers& answers;
    std::vector<std::string> pictures{};  // of each step, SVG; empty: none
    std::string program{};                // "tactspace 0.1.0"
};

std::string lesson_sheet(const LessonSheet& sheet);

}  // namespace tact
