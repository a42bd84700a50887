// The current step as fields: texts, question, camera, and buttons.
//
// Left out  pattern, partner, stage and times, which are taken from the screen (lesson_edit.h)
#pragma once

#include <string>

#include "app/lesson/lesson.h"

namespace tact {

void draw_step_editor(const LessonContext& context, LessonState& state);

// A text with its label above; "lesson edit:ID" for tests. True if it changed.
bool edit_text(Ui& ui, TextBox& box, const char* id, const char* label, int lines,
               std::string& text);

}  // namespace tact
