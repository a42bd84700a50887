// Writing a lesson in the program: steps made of what is on screen, their texts and order.
//
// Output    the lesson as a new value; nothing of it is on the disk before it is saved
// Left out  undo of what was written; questions and pictures of the map's camera are edited in the
//           file
#pragma once

#include <filesystem>

#include "app/lesson/lesson.h"

namespace tact {

// A step that shows what is shown now.
LessonStep step_from_screen(const LessonHands& hands);

// Of the open document, with one step that shows what is on screen; it is edited at once.
void new_lesson(const LessonHands& hands, LessonState& state);

void toggle_editing(const LessonHands& hands, LessonState& state);

// Behind the step under way, which it becomes.
void add_step(const LessonHands& hands, LessonState& state);
void remove_step(const LessonHands& hands, LessonState& state);
void move_step(const LessonHands& hands, LessonState& state, int by);

// The texts of the step under way, and what to do with it.
void draw_step_editor(const LessonHands& hands, LessonState& state);

// With its set as it is now.
Lesson lesson_to_save(const Workspace& work, const LessonState& state);
void save_lesson_dialog(Ui& ui, const Workspace& work, const LessonState& state);
void save_lesson(Ui& ui, const Workspace& work, LessonState& state,
                 const std::filesystem::path& path);
void open_lesson_dialog(Ui& ui, const Workspace& work);
void save_sheet_dialog(Ui& ui, const Workspace& work, const LessonState& state);

}  // namespace tact
