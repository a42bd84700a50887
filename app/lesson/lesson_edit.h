// Writing a lesson in the program: steps made from the screen, their texts and order.
//
// Output    the lesson as a new value; files change only when it is saved
// Left out  its fields (step_editor.h, question_editor.h)
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/lesson/lesson.h"

namespace tact {

// A step that shows the present view.
LessonStep step_from_screen(const LessonContext& context);

// Starts a lesson of the open document, with one step that shows the present view, in the editor.
void new_lesson(const LessonContext& context, LessonState& state);

// The same with a lesson that was written before for the open set.
void write_on_document(const LessonContext& context, LessonState& state,
                       std::shared_ptr<const Lesson> lesson);

void toggle_editing(const LessonContext& context, LessonState& state);

// One step of undo; with `joins` it merges with the last one of the same name. Texts of the step
// are in the shown language.
void change_lesson(const LessonContext& context, LessonState& state, Lesson lesson,
                   const std::string& what, bool joins = false);
void change_step(const LessonContext& context, LessonState& state, const LessonStep& step,
                 const std::string& what, bool joins = false);

void undo_lesson(const LessonContext& context, LessonState& state);
void redo_lesson(const LessonContext& context, LessonState& state);

// Ctrl+Z belongs to the lesson until the document changes.
bool was_lesson_edited_last(const Workspace& work, const LessonState& state);

// Takes pattern, partner, stage, times and camera of the current step from the screen.
void show_screen(const LessonContext& context, LessonState& state);
void take_camera(const LessonContext& context, LessonState& state, bool taken);

// Adds a step behind the current one, and goes to it.
void add_step(const LessonContext& context, LessonState& state);
void remove_step(const LessonContext& context, LessonState& state);
void move_step(const LessonContext& context, LessonState& state, int by);

// Name and description of the lesson, in the shown language.
void change_name(const LessonContext& context, LessonState& state, const LessonWords& shown,
                 bool joins = false);

// Replaces the lesson by a copy, "NAME copy", which is in no file yet. Unsaved changes of the
// lesson are in the copy.
void duplicate_lesson(const LessonContext& context, LessonState& state);

// Adds a language and shows it, to be written in.
void add_language(const LessonContext& context, LessonState& state, const std::string& code);
// Removes the shown language with all its texts, unless it is the first.
void remove_language(const LessonContext& context, LessonState& state);

// The lesson with its set as the document has it.
Lesson lesson_to_save(const Workspace& work, const LessonState& state);
void save_lesson_dialog(Ui& ui, const Workspace& work, const LessonState& state);
// An incomplete lesson is saved as a draft. False: it could not be saved.
bool save_lesson(Ui& ui, Workspace& work, LessonState& state, const std::filesystem::path& path);

// Tells what is still missing before a class can see the lesson.
void check_lesson(Ui& ui, const Workspace& work, const LessonState& state);

void open_lesson_dialog(Ui& ui, const Workspace& work);
void open_course_dialog(Ui& ui, const Workspace& work);
void save_sheet_dialog(Ui& ui, const Workspace& work, LessonState& state);
// A sheet for another teacher, with notes, answers and the lesson file inside.
void hand_on_dialog(Ui& ui, const Workspace& work, LessonState& state);

}  // namespace tact
