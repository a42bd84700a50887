// Parts that the files of this room share.
#pragma once

#include <string>

#include "app/lesson/lesson.h"

namespace tact {

// The question of a step as fields: its kind, words and options.
//
// Output    steps of undo of the lesson; answers that the model gives are not typed

void draw_question_editor(const LessonContext& context, LessonState& state);

// The current step as fields: texts, question, camera, and buttons.
//
// Left out  pattern, partner, stage and times, which are taken from the screen

void draw_step_editor(const LessonContext& context, LessonState& state);

// A text with its label above; "lesson edit:ID" for tests. True if it changed.
bool edit_text(Ui& ui, TextBox& box, const char* id, const char* label, int lines,
               std::string& text);

}  // namespace tact
