// The question of a step as fields: its kind, words and options.
//
// Output    steps of undo of the lesson; answers that the model gives are not typed
#pragma once

#include "app/lesson/lesson.h"

namespace tact {

void draw_question_editor(const LessonContext& context, LessonState& state);

}  // namespace tact
