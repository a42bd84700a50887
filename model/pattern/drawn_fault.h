// What is wrong with the curves and transients of a pattern, found in one place for files, editors
// and importers.
//
// Times lie within the pattern and rise, but that two points may share one: a jump. The numbers of
// points and transients are limited (model/pattern/curves.h).
#pragma once

#include <optional>
#include <string>

#include "model/pattern/pattern.h"

namespace tact {

struct DrawnFault {
    std::string place;     // of the pattern: "amplitude_curve/7/time_s"
    std::string expected;  // "a number from 0 to 1"
    double got = 0.0;
};

// The first one; none: the pattern can be rendered, edited and saved.
std::optional<DrawnFault> drawn_fault(const Pattern& pattern);

// "amplitude_curve/7/time_s: expected a number from 0 to 1, got 1.5"
std::string sentence(const DrawnFault& fault);

}  // namespace tact
