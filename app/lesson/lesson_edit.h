// Writing a lesson in the program: steps made of what is on screen, their texts and order.
//
// Output    the lesson as a new value; nothing of it is on the disk before it is saved
// Left out  its fields (step_editor.h, question_editor.h)
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/lesson/lesson.h"

namespace tact {

// A step that shows what is shown now.
LessonStep step_from_screen(const LessonHands& hands);

// Of the open document, with one step that shows what is on screen; it is edited at once.
void new_lesson(const LessonHands& hands, LessonState& state);

// The same with a lesson that was written before, of the set that is open.
void write_on_document(const LessonHands& hands, LessonState& state,
                       std::shared_ptr<const Lesson> lesson);

void toggle_editing(const LessonHands& hands, LessonState& state);

// A step of undo; with `joins` it is one with the last, where that was called the same. The step's
// texts are in the language that is shown.
void change_lesson(const LessonHands& hands, LessonState& state, Lesson lesson,
                   const std::string& what, bool joins = false);
void change_step(const LessonHands& hands, LessonState& state, const LessonStep& step,
                 const std::string& what, bool joins = false);

void undo_lesson(const LessonHands& hands, LessonState& state);
void redo_lesson(const LessonHands& hands, LessonState& state);

// Ctrl+Z is the lesson's until the document was changed.
bool was_lesson_edited_last(const Workspace& work, const LessonState& state);

// Pattern, partner, stage, times and camera of the step under way, as they are on screen.
void show_screen(const LessonHands& hands, LessonState& state);
void take_camera(const LessonHands& hands, LessonState& state, bool taken);

// Behind the step under way, which it becomes.
void add_step(const LessonHands& hands, LessonState& state);
void remove_step(const LessonHands& hands, LessonState& state);
void move_step(const LessonHands& hands, LessonState& state, int by);

// Name and about of the lesson, in the language that is shown.
void change_name(const LessonHands& hands, LessonState& state, const LessonWords& shown,
                 bool joins = false);

// A copy in the place of the lesson, to be written: "NAME copy", in no file. What was unsaved of
// the lesson is in the copy.
void duplicate_lesson(const LessonHands& hands, LessonState& state);

// Shown at once, to be written in.
void add_language(const LessonHands& hands, LessonState& state, const std::string& code);
// The one that is shown, unless it is the first, with all that was written in it.
void remove_language(const LessonHands& hands, LessonState& state);

// With its set as it is now.
Lesson lesson_to_save(const Workspace& work, const LessonState& state);
void save_lesson_dialog(Ui& ui, const Workspace& work, const LessonState& state);
// A lesson that lacks something is saved as a draft. False: it could not be saved.
bool save_lesson(Ui& ui, Workspace& work, LessonState& state, const std::filesystem::path& path);

// Tells what the lesson lacks before a class can see it.
void check_lesson(Ui& ui, const Workspace& work, const LessonState& state);

void open_lesson_dialog(Ui& ui, const Workspace& work);
void open_course_dialog(Ui& ui, const Workspace& work);
void save_sheet_dialog(Ui& ui, const Workspace& work, LessonState& state);
// For another teacher: the sheet with notes and answers, and the lesson in it.
void hand_on_dialog(Ui& ui, const Workspace& work, LessonState& state);

}  // namespace tact
