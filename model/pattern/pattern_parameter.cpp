#include "model/pattern/pattern_parameter.h"

#include <algorithm>

namespace tact {

namespace {

// clang-format off
constexpr std::array<ParameterTraits, 9> kTraits{{
    {"amplitude_g", "amplitude", "g", limits::kAmplitudeG, {0.0, 4.0}, true, 0.05, 0.001},
    {"carrier_hz", "carrier", "Hz", limits::kCarrierHz, {10.0, 500.0}, true, 0.0, 0.0},
    {"second_carrier_hz", "second carrier", "Hz", limits::kCarrierHz, {10.0, 500.0}, true, 0.0, 0.0},
    {"mix", "weight of the second carrier", "", limits::kCarrierWeight, {0.0, 1.0}, false, 0.0, 0.0},
    {"modulation_hz", "modulation", "Hz", limits::kModulationHz, {0.0, 100.0}, true, 1.0, 1.0},
    {"depth", "depth", "", limits::kDepth, limits::kDepth, false, 0.0, 0.0},
    {"rhythm_unit_s", "rhythm unit", "s", limits::kRhythmUnitS, {0.005, 0.5}, true, 0.0, 0.0},
    {"attack_s", "attack", "s", limits::kRampS, {0.0, 0.5}, false, 0.0, 0.0},
    {"release_s", "release", "s", limits::kRampS, {0.0, 0.5}, false, 0.0, 0.0}}};
// clang-format on

// The number itself, in either kind of pattern.
template <class SomePattern>
auto* number_of(SomePattern& pattern, PatternParameter parameter) {
    auto* none = static_cast<decltype(&pattern.amplitude_g)>(nullptr);
    const bool has_second = pattern.carriers.size() > 1;
    switch (parameter) {
        case PatternParameter::amplitude:
            return &pattern.amplitude_g;
        case PatternParameter::carrier:
            // A drawn frequency is no number.
            if (pattern.carriers.empty() || !pattern.frequency_curve.empty()) return none;
            return &pattern.carriers[0].frequency_hz;
        case PatternParameter::second_carrier:
            return has_second ? &pattern.carriers[1].frequency_hz : none;
        case PatternParameter::mix:
            return has_second ? &pattern.carriers[1].weight : none;
        case PatternParameter::modulation:
            return &pattern.modulation.frequency_hz;
        case PatternParameter::depth:
            return pattern.modulation.kind == ModulationKind::am ? &pattern.modulation.depth : none;
        case PatternParameter::rhythm_unit:
            return pattern.rhythm.text.empty() ? none : &pattern.rhythm.unit_s;
        case PatternParameter::attack:
            return &pattern.attack_s;
        case PatternParameter::release:
            return &pattern.release_s;
    }
    return none;
}

}  // namespace

const ParameterTraits& traits(PatternParameter parameter) {
    return kTraits[static_cast<std::size_t>(parameter)];
}

std::optional<double> value_of(const Pattern& pattern, PatternParameter parameter) {
    const double* number = number_of(pattern, parameter);
    if (number == nullptr) return std::nullopt;
    return *number;
}

Pattern with_value(Pattern pattern, PatternParameter parameter, double value) {
    double* number = number_of(pattern, parameter);
    const Range& range = traits(parameter).range;
    if (number != nullptr) *number = std::clamp(value, range.low, range.high);
    return pattern;
}

}  // namespace tact
