#include "model/pattern/felt_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/common/portable.h"
#include "model/pattern/same_vibration.h"

namespace tact {

namespace {

std::size_t place_in_order(PatternParameter parameter) {
    return static_cast<std::size_t>(parameter);
}

// The first value above zero is one step, as the least of it is felt; further steps are ratios.
double steps_from_zero(const FeltSteps& steps, PatternParameter parameter, double value) {
    const double first = traits(parameter).first;
    if (value <= first) return 1.0;
    return 1.0 + portable::log(value / first) / portable::log(step_of(steps, parameter));
}

// A step up and one down again may come to a little less than where they began.
constexpr double kUpToRounding = 1.0 - 1e-9;

double stepped_by_ratio(const ParameterTraits& about, double step, double value, double count) {
    if (value <= 0.0) return count < 1.0 ? 0.0 : about.first * portable::pow(step, count - 1.0);
    const double moved = value * portable::pow(step, count);
    if (count < 0.0) return moved < kUpToRounding * about.least ? 0.0 : moved;
    // What is next to nothing has no more digits to grow by.
    return count > 0.0 ? std::max(moved, std::nextafter(value, about.range.high)) : value;
}

}  // namespace

StepSizes usual_felt_steps() {
    StepSizes sizes{};
    for (const PatternParameter parameter : kPatternParameters) {
        sizes[place_in_order(parameter)] = traits(parameter).step;
    }
    return sizes;
}

Range step_range(PatternParameter parameter) {
    const ParameterTraits& about = traits(parameter);
    return about.by_ratio ? Range{1.01, 4.0} : Range{0.001, about.range.high};
}

double step_of(const FeltSteps& steps, PatternParameter parameter) {
    return steps.size[place_in_order(parameter)];
}

double stepped(const FeltSteps& steps, PatternParameter parameter, double value, double count) {
    const ParameterTraits& about = traits(parameter);
    const double step = step_of(steps, parameter);
    const double moved =
        about.by_ratio ? stepped_by_ratio(about, step, value, count) : value + step * count;
    return std::clamp(moved, about.range.low, about.range.high);
}

double steps_between(const FeltSteps& steps, PatternParameter parameter, double a, double b) {
    if (a == b) return 0.0;
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    if (!traits(parameter).by_ratio) return (high - low) / step_of(steps, parameter);
    if (low <= 0.0) return steps_from_zero(steps, parameter, high);
    return portable::log(high / low) / portable::log(step_of(steps, parameter));
}

FeltDifference felt_difference(const FeltSteps& steps, const Pattern& a, const Pattern& b) {
    FeltDifference difference;
    Pattern plain_a = a;
    Pattern plain_b = b;
    for (const PatternParameter parameter : kPatternParameters) {
        const auto of_a = value_of(a, parameter);
        const auto of_b = value_of(b, parameter);
        if (of_a.has_value() != of_b.has_value()) difference.same_shape = false;
        if (!of_a || !of_b) continue;
        difference.steps =
            std::max(difference.steps, steps_between(steps, parameter, *of_a, *of_b));
        plain_a = with_value(plain_a, parameter, *of_a);
        plain_b = with_value(plain_b, parameter, *of_a);
    }
    const double longer_s = std::max(a.duration_s, b.duration_s);
    const double shorter_s = std::min(a.duration_s, b.duration_s);
    const double unit = step_of(steps, PatternParameter::rhythm_unit);
    const double longer = portable::log(longer_s / shorter_s) / portable::log(unit);
    // Where a ratio of one step is meant, it is one step to the bit.
    const bool is_a_step = longer_s >= shorter_s * unit;
    difference.steps = std::max(difference.steps,
                                is_a_step ? std::max(longer, 1.0) : std::min(longer, 1.0 - 1e-12));
    plain_b.duration_s = a.duration_s;
    difference.same_shape = difference.same_shape && essence(plain_a) == essence(plain_b);
    return difference;
}

StepSizes places_in_steps(const FeltSteps& steps, const Pattern& pattern) {
    StepSizes places{};
    for (const PatternParameter parameter : kPatternParameters) {
        const auto value = value_of(pattern, parameter);
        const double step = step_of(steps, parameter);
        places[place_in_order(parameter)] = !value ? std::numeric_limits<double>::quiet_NaN()
                                            : traits(parameter).by_ratio
                                                ? portable::log(*value) / portable::log(step)
                                                : *value / step;
    }
    return places;
}

bool within_a_step(const FeltSteps& steps, const Pattern& a, const Pattern& b) {
    // Most pairs are told by one number: no essence is made of them.
    for (const PatternParameter parameter : kPatternParameters) {
        const auto of_a = value_of(a, parameter);
        const auto of_b = value_of(b, parameter);
        if (of_a.has_value() != of_b.has_value()) return false;
        if (of_a && steps_between(steps, parameter, *of_a, *of_b) >= 1.0) return false;
    }
    const FeltDifference difference = felt_difference(steps, a, b);
    return difference.same_shape && difference.steps < 1.0;
}

}  // namespace tact
