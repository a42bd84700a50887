// A lesson on paper, as one page that needs no other file: for students to fill in, or for another
// teacher, with notes and answers beside the steps and the lesson file inside.
//
// Input     the lesson, its numbers and answers, a picture of each step
// Output    HTML (app/report/html.h): steps with pictures and texts, questions with room for an
//           answer, the answers on a separate page, the sources
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
    std::vector<std::string> pictures{};  // SVG of each step; empty: no picture
    std::string program{};                // "tactspace 0.1.0"
    // For a teacher: the lesson file, which the page contains; empty: for students.
    std::string lesson_file{};
};

std::string lesson_sheet(const LessonSheet& sheet);

// The lesson as a file that needs no other: with its set, and all its languages. An Error if the
// set has recordings, whose waveforms a lesson file cannot hold.
Expected<std::string> whole_lesson_file(Lesson lesson);

}  // namespace tact
