// The cover of a course: whose progress it is, where each lesson stands, and the way on.
#pragma once

#include <cstddef>
#include <optional>

#include "app/course/course_state.h"
#include "app/ui/ui.h"

namespace tact {

// The lesson to begin, which the dialog has given way to.
std::optional<std::size_t> draw_course_dialog(Ui& ui, CourseState& state);

}  // namespace tact
