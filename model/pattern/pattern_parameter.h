// The numbers of a pattern, one by one: to colour, filter and join patterns by, and to change.
//
// Input     a parametric pattern
// Valid     of the carriers, the first and the second; the second's weight is the mix. Ranges are
//           those of files (limits::), so that no change moves a number that a file may hold
// Left out  phases, further carriers, the rhythm's notes, what is drawn, the duration, which all
//           patterns share.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "model/common/units.h"
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

inline constexpr auto kPatternParameters = [] {
    constexpr auto kLast = static_cast<std::size_t>(PatternParameter::release);
    std::array<PatternParameter, kLast + 1> all{};
    for (std::size_t k = 0; k <= kLast; ++k) all[k] = static_cast<PatternParameter>(k);
    return all;
}();

// What a number is, said once: files, fields and felt steps all go by it.
struct ParameterTraits {
    const char* key;   // amplitude_g
    const char* name;  // amplitude
    const char* unit;  // g
    Range range;       // what files may hold, and a person may type
    Range slider;      // what a slider shows; numbers beside it are as good
    // Whether changes of it are felt by ratio (model/pattern/felt_steps.h). Then one from 0 begins
    // at `first`, and one that would end below `least` ends at 0; both 0 where the range has no 0.
    bool by_ratio;
    double first;
    double least;
    // The least change that is felt, a factor if by_ratio, otherwise a difference; its source,
    // "Israr, Tan & Reed 2006"; and whether it is a guess, as that measured something else.
    double step;
    const char* step_source;
    bool step_is_guess;
};

const ParameterTraits& traits(PatternParameter parameter);

// None where the pattern has no such number: no second carrier, no depth of a product, no carrier
// where its frequency is a curve.
std::optional<double> value_of(const Pattern& pattern, PatternParameter parameter);

// The pattern with the number, put in the range that files have; unchanged where it has none.
Pattern with_value(Pattern pattern, PatternParameter parameter, double value);

}  // namespace tact
