// A course: lessons in an order; and how far each student has come in lessons.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace tact {

struct Course {
    std::string name;
    std::string about;
    // "beats", one that comes with the program; or a lesson file, relative to the course's.
    std::vector<std::string> lessons;
    std::string unknown_json;  // keys of the file that this version does not know, kept on save

    bool operator==(const Course&) const = default;
};

// What a student said before the answer was seen.
struct GivenAnswer {
    std::string question;
    std::string answer;
    bool right = false;
    std::string at;  // UTC

    bool operator==(const GivenAnswer&) const = default;
};

struct LessonProgress {
    std::size_t reached = 0;                     // steps seen, from the first
    std::size_t steps = 0;                       // of the lesson
    std::map<std::size_t, GivenAnswer> answers;  // by step, from 0

    bool operator==(const LessonProgress&) const = default;
};

using StudentProgress = std::map<std::string, LessonProgress>;  // by lesson: its file or asset
using ClassProgress = std::map<std::string, StudentProgress>;   // by the student's name

}  // namespace tact
