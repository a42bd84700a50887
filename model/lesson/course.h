// A course: an ordered list of lessons; and each student's progress in lessons.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace tact {

struct Course {
    std::string name;
    std::string about;
    // "beats", a bundled lesson; or a lesson file, relative to the course's.
    std::vector<std::string> lessons;
    std::string unknown_json;  // unknown keys of the file, kept on save

    bool operator==(const Course&) const = default;
};

// An answer of a student before the right one was revealed.
struct GivenAnswer {
    std::string question;
    std::string answer;
    bool right = false;
    std::string at;  // UTC

    bool operator==(const GivenAnswer&) const = default;
};

struct LessonProgress {
    std::size_t reached = 0;                     // number of seen steps, from the first
    std::size_t steps = 0;                       // steps of the lesson
    std::map<std::size_t, GivenAnswer> answers;  // by step, from 0

    bool operator==(const LessonProgress&) const = default;
};

using StudentProgress = std::map<std::string, LessonProgress>;  // by lesson: its file or asset
using ClassProgress = std::map<std::string, StudentProgress>;   // by the student's name

}  // namespace tact
