// The step under way as fields: texts, question, camera, and what to do with it.
//
// Left out  pattern, partner, stage and times, which are taken from the screen (lesson_edit.h)
#pragma once

#include <string>

#include "app/lesson/lesson.h"

namespace tact {

void draw_step_editor(const LessonHands& hands, LessonState& state);

// A text with its label above; "lesson edit:ID" for tests. True when it was changed.
bool edit_text(Ui& ui, TextBox& box, const char* id, const char* label, int lines,
               std::string& text);

}  // namespace tact
