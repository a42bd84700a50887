// The course file, `.tactcourse.json`, and the progress of a class.
//
//     {
//       "tactcourse": 1,                the format
//       "name": "Touch", "about": "Audience, duration",
//       "lessons": ["tour", "mine.tactlesson.json"]   in order: names of bundled lessons,
//                                       or lesson files, relative to this one
//     }
//
// Source    format 1: UTF-8 JSON; unknown keys are kept on save
// Output    errors as "FILE: PLACE: expected .."
// Valid     at most kMaxCourseLessons lessons, each once
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/lesson/lesson.h"

namespace tact {

inline constexpr int kCourseFormat = 1;
inline constexpr const char* kCourseEnding = ".tactcourse.json";
inline constexpr std::size_t kMaxCourseLessons = 100;

bool is_course_file(const std::filesystem::path& path);

Expected<Course> parse_course(std::string_view text, const std::string& name_for_messages);
Expected<Course> read_course_file(const std::filesystem::path& path);
std::string print_course(const Course& course);

// Students' progress, in the program's own file.
Expected<ClassProgress> parse_progress(std::string_view text, const std::string& name_for_messages);
std::string print_progress(const ClassProgress& progress);

// One row per answer: student, lesson, step from 1, question, answer, right as 1 or 0, when as UTC
// to the minute.
std::string answers_csv(const ClassProgress& progress);

}  // namespace tact
