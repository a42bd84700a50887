// The numbers of a pattern, one by one: to colour, filter and join patterns by, and to change.
//
// Input     a parametric pattern
// Valid     of the carriers, the first and the second; the second's weight is the mix
// Left out  phases, further carriers, the rhythm's notes, what is drawn, the duration, which all
//           patterns share.
#pragma once

#include <array>
#include <optional>

#include "model/common/range.h"
#include "model/pattern/pattern.h"

namespace tact {

enum class PatternParameter {
    amplitude,
    carrier,
    second_carrier,
    mix,
    modulation,
    depth,
    rhythm_unit,
    attack,
    release
};

inline constexpr std::array<PatternParameter, 9> kPatternParameters{
    PatternParameter::amplitude,   PatternParameter::carrier,    PatternParameter::second_carrier,
    PatternParameter::mix,         PatternParameter::modulation, PatternParameter::depth,
    PatternParameter::rhythm_unit, PatternParameter::attack,     PatternParameter::release};

struct ParameterTraits {
    const char* key;   // amplitude_g
    const char* name;  // amplitude
    const char* unit;  // g
    Range range;
    // Whether changes of it are felt by ratio (model/pattern/felt_steps.h); then one from 0 begins
    // at `first`.
    bool by_ratio;
    double first;
};

const ParameterTraits& traits(PatternParameter parameter);

// None where the pattern has no such number: no second carrier, no depth of a product, no carrier
// where its frequency is a curve.
std::optional<double> value_of(const Pattern& pattern, PatternParameter parameter);

// The pattern with the number put in range; unchanged where it has none.
Pattern with_value(Pattern pattern, PatternParameter parameter, double value);

}  // namespace tact
