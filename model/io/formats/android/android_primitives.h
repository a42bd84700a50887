// Patterns that consist of Android's primitives, as those.
//
// A device plays its own course of each, so only what has the assumed courses, to the last
// hundredth, counts as one: what was read from such a file, at any scale and delay.
#pragma once

#include <optional>
#include <vector>

#include "model/io/effects/actuator_map.h"
#include "model/io/formats/android/android_courses.h"
#include "model/pattern/pattern.h"

namespace tact {

struct PlayedPrimitive {
    const AssumedCourse* course = nullptr;
    double scale = 1.0;  // above 0, at most 1
    double start_s = 0.0;
    double end_s = 0.0;
};

// In the order in which they begin; none: the pattern is something else.
std::optional<std::vector<PlayedPrimitive>> as_primitives(const Pattern& pattern,
                                                          const ActuatorMap& map);

}  // namespace tact
