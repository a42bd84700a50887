// A lesson on paper: what students take home or fill in, as one page that stands alone; or what one
// teacher hands on to another, with notes and answers beside the steps and the lesson within.
//
// Input     the lesson, its numbers and answers, a picture of each step
// Output    HTML (app/report/html.h): steps with pictures and texts, questions with room for an
//           answer, the answers on a page of their own, the sources
// Exact     same input, same bytes.
#pragma once

#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/lesson/lesson_numbers.h"

namespace tact {

struct LessonSheet {
    const Lesson& lesson;
    const LessonAnswers& answers;
    std::vector<std::string> pictures{};  // of each step, SVG; empty: none
    std::string program{};                // "tactspace 0.1.0"
    // To be handed on: the lesson file, which is within the page; empty: it is for students.
    std::string lesson_file{};
};

std::string lesson_sheet(const LessonSheet& sheet);

// The lesson as a file that needs no other: with its set, and all of its languages. An Error: the
// set has recordings, of which a file has the names alone.
Expected<std::string> whole_lesson_file(Lesson lesson);

}  // namespace tact
