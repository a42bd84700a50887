// The least change of each number of a pattern that people are taken to feel, and what is counted
// in such changes.
//
// Source    amplitude: about 1.5 dB (Craig 1972, as it is cited; 2.2 to 2.5 dB at the fingertip:
//           Israr, Tan & Reed 2006). Frequency: 18 to 25 % at the fingertip, 2 to 200 Hz (Israr,
//           Tan & Reed 2006). A rhythm's unit, so how long notes and gaps are: 160 ms of 1 s
//           (Jones, Poliakoff & Wells 2009). Ramps: 30 ms part a pulse from a vibration
//           (Remache-Vinueza, Trujillo-Leon & Vidal-Verdu 2025), taken for what is felt of a ramp:
//           a guess. The rate of a modulation as of a carrier, and a fifth of mix and depth:
//           guesses.
// Valid     one finger, well above threshold, one number changed at a time
// Left out  that small changes of several numbers add up.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "model/pattern/pattern_parameter.h"

namespace tact {

// In the order of kPatternParameters; the usual ones are traits().step.
using StepSizes = std::array<double, kPatternParameters.size()>;
StepSizes usual_felt_steps();

struct FeltSteps {
    StepSizes size = usual_felt_steps();

    bool operator==(const FeltSteps&) const = default;
};

// What a step may be: a factor above 1, or a part of the number's range.
Range step_range(PatternParameter parameter);

double step_of(const FeltSteps& steps, PatternParameter parameter);

// The value `count` steps away, in range: a step up is more, a step down is less, unless the range
// ends. By ratio, the first step from 0 leads to traits().first; a value below traits().least on
// the way down is 0.
double stepped(const FeltSteps& steps, PatternParameter parameter, double value, double count);

// How many steps two values are apart, at least 0; not whole. From 0 of what goes by ratio to
// anything else at least one.
double steps_between(const FeltSteps& steps, PatternParameter parameter, double a, double b);

// How far two patterns are apart in such steps.
struct FeltDifference {
    double steps = 0.0;      // the most that any number differs by, and how long they are
    bool same_shape = true;  // nothing else that is felt differs: rhythm, kinds, curves, transients
};
FeltDifference felt_difference(const FeltSteps& steps, const Pattern& a, const Pattern& b);

// Where the numbers of a pattern stand, in steps from a point that all patterns share; NaN of what
// it has not. For sets of many pairs: two patterns of which a number stands more than a step apart,
// to rounding, are not within a step.
StepSizes places_in_steps(const FeltSteps& steps, const Pattern& pattern);
inline bool may_be_within_a_step(const StepSizes& a, const StepSizes& b) {
    constexpr double kRounded = 1.0 + 1e-9;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (std::abs(a[k] - b[k]) > kRounded) return false;
    }
    return true;
}

// Whether two patterns differ by less than a step in every number, and in nothing else that is
// felt. So as long as one another, to a step of a rhythm's unit.
bool within_a_step(const FeltSteps& steps, const Pattern& a, const Pattern& b);

}  // namespace tact
