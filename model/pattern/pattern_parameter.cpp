#include "model/pattern/pattern_parameter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

// A parameter by the number that it is; `first` and `least` of what goes by ratio.
constexpr ParameterTraits of(const char* key, const char* name, const char* unit,
                             const Number& number, bool by_ratio, double first = 0.0,
                             double least = 0.0) {
    return {key, name, unit, number.range, number.slider, by_ratio, first, least};
}

constexpr std::array<ParameterTraits, 9> kTraits{
    of("amplitude_g", "amplitude", "g", numbers::kAmplitude, true, 0.05, 0.001),
    of("carrier_hz", "carrier", "Hz", numbers::kCarrier, true),
    of("second_carrier_hz", "second carrier", "Hz", numbers::kCarrier, true),
    of("mix", "weight of the second carrier", "", numbers::kWeight, false),
    of("modulation_hz", "modulation", "Hz", numbers::kModulation, true, 1.0, 1.0),
    of("depth", "depth", "", numbers::kDepth, false),
    of("rhythm_unit_s", "rhythm unit", "s", numbers::kRhythmUnit, true),
    of("attack_s", "attack", "s", numbers::kAttack, false),
    of("release_s", "release", "s", numbers::kRelease, false)};

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

// Times in order, at most two of them equal.
template <class Point>
void keep_rules(std::vector<Point>& curve) {
    double latest_s = 0.0;
    for (Point& point : curve) {
        latest_s = std::max(latest_s, std::min(point.time_s, limits::kDurationS.high));
        point.time_s = latest_s;
    }
    // If there are more than two, the first and the last are the jump.
    std::vector<Point> kept;
    for (const Point& point : curve) {
        const std::size_t n = kept.size();
        const bool third = n > 1 && kept[n - 2].time_s == point.time_s;
        if (third) kept.pop_back();
        kept.push_back(point);
    }
    kept.resize(std::min(kept.size(), limits::kMaxCurvePoints));
    curve = std::move(kept);
}

}  // namespace

Pattern clamped(Pattern pattern) {
    if (pattern.carriers.empty()) pattern.carriers.emplace_back();
    pattern.carriers.resize(std::min(pattern.carriers.size(), limits::kMaxCarriers));
    pattern.transients.resize(std::min(pattern.transients.size(), limits::kMaxTransients));
    clamp_numbers(pattern);
    keep_rules(pattern.amplitude_curve);
    keep_rules(pattern.frequency_curve);
    for (Transient& transient : pattern.transients) {
        transient.time_s = std::clamp(transient.time_s, 0.0, limits::kDurationS.high);
    }
    const double length_s = pattern.duration_s;
    return with_duration(std::move(pattern), length_s);
}

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
