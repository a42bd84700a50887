// Steps of a lesson as JSON and back. Private to the lesson file.
#pragma once

#include "model/lesson/lesson.h"
#include "model/text/json_fields.h"

namespace tact {

// A step, with its patterns and numbers looked up in `set`. A draft may lack what
// model/lesson/lesson_lacks.h lists.
LessonStep step_of(JsonObject& object, const PatternSet& set, bool is_draft);

// Only what differs from the defaults.
Json json_of(const LessonStep& step);

}  // namespace tact
