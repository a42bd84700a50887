// Courses: the cover, how far each student has come.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/lesson/lesson.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "model/lesson/lesson.h"

namespace tact {

// A course that is open: its lessons, whose progress is kept, and what a class did so far.
//
// A student's name may be empty: then nothing is kept. Answers are those given alone, before the
// answer is seen, and not those of a class that is presented to.

struct CourseLesson {
    std::shared_ptr<const Lesson> lesson;  // null: it could not be read ...
    std::string fault;                     // ... for this reason
    std::string key;                       // LessonState::key of it
    std::filesystem::path path;            // of its file; empty: it comes with the program
};

struct CourseState {
    std::optional<Course> course;
    std::vector<CourseLesson> lessons;
    std::string student;
    ClassProgress progress;  // of all students of this computer
    bool is_read = false;    // what was kept of them
    std::string fault;       // why nothing more is kept; empty: it is
    bool has_begun = false;  // a lesson, from the cover
    std::string last_key;    // of the lesson that was under way in the last frame
};

// Where it is kept; empty: nowhere.
std::filesystem::path progress_file(const Session& session);

Expected<ClassProgress> read_progress(const std::filesystem::path& file);

// Shows its cover.
void open_course(Ui& ui, const Session& session, CourseState& state, const Course& course,
                 const std::filesystem::path& folder);
void open_course_file(Ui& ui, Session& session, CourseState& state,
                      const std::filesystem::path& path);
void open_bundled_course(Ui& ui, const Session& session, CourseState& state);

// The first lesson that is not finished; none: all are.
std::optional<std::size_t> next_lesson(const CourseState& state);

// Where the student was, and is again.
void begin_course_lesson(const LessonContext& context, LessonState& lesson, CourseState& state,
                         std::size_t which);

// Once a frame: keeps what the student reached and answered; shows the cover again when a lesson
// ends that was begun there.
void follow_course(Ui& ui, const Session& session, const LessonState& lesson, CourseState& state);

struct CourseScore {
    std::size_t right = 0;
    std::size_t asked = 0;
};
CourseScore score_of(const LessonProgress& progress);

// What the student did of a lesson; null: nothing yet.
const LessonProgress* progress_of(const CourseState& state, const CourseLesson& lesson);

void export_answers(Ui& ui, const CourseState& state, const std::filesystem::path& file);

// The cover of a course: whose progress it is, where each lesson stands, and the way on.

// The lesson to begin, which the dialog has given way to.
// Its title on the screen is the course's name.
inline constexpr Dialog kCourseDialog{.title = "Course"};
std::optional<std::size_t> draw_course_dialog(Ui& ui, CourseState& state);

}  // namespace tact
