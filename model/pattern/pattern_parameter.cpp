#include "model/pattern/pattern_parameter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

// A parameter by the number that it is, and where a pattern has it; null where it has none.
struct DescribedParameter {
    ParameterTraits traits;
    const double* (*at)(const Pattern&);
};

// `first` and `least`: of what goes by ratio.
constexpr ParameterTraits of(const char* key, const char* name, const char* unit,
                             const Number& number, bool by_ratio, double first = 0.0,
                             double least = 0.0) {
    return {key, name, unit, number.range, number.slider, by_ratio, first, least};
}

const Carrier* second_of(const Pattern& p) {
    return p.carriers.size() > 1 ? &p.carriers[1] : nullptr;
}

// clang-format off
constexpr std::array<DescribedParameter, 9> kParameters{{
    {of("amplitude_g", "amplitude", "g", numbers::kAmplitude, true, 0.05, 0.001),
     [](const Pattern& p) { return &p.amplitude_g; }},
    {of("carrier_hz", "carrier", "Hz", numbers::kCarrier, true),
     // A drawn frequency is no number.
     [](const Pattern& p) { return p.carriers.empty() || !p.frequency_curve.empty() ? nullptr : &p.carriers[0].frequency_hz; }},
    {of("second_carrier_hz", "second carrier", "Hz", numbers::kCarrier, true),
     [](const Pattern& p) { return second_of(p) == nullptr ? nullptr : &second_of(p)->frequency_hz; }},
    {of("mix", "weight of the second carrier", "", numbers::kWeight, false),
     [](const Pattern& p) { return second_of(p) == nullptr ? nullptr : &second_of(p)->weight; }},
    {of("modulation_hz", "modulation", "Hz", numbers::kModulation, true, 1.0, 1.0),
     [](const Pattern& p) { return &p.modulation.frequency_hz; }},
    {of("depth", "depth", "", numbers::kDepth, false),
     [](const Pattern& p) { return p.modulation.kind == ModulationKind::am ? &p.modulation.depth : nullptr; }},
    {of("rhythm_unit_s", "rhythm unit", "s", numbers::kRhythmUnit, true),
     [](const Pattern& p) { return p.rhythm.text.empty() ? nullptr : &p.rhythm.unit_s; }},
    {of("attack_s", "attack", "s", numbers::kAttack, false), [](const Pattern& p) { return &p.attack_s; }},
    {of("release_s", "release", "s", numbers::kRelease, false), [](const Pattern& p) { return &p.release_s; }}}};
// clang-format on

const DescribedParameter& described(PatternParameter parameter) {
    return kParameters[static_cast<std::size_t>(parameter)];
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

const ParameterTraits& traits(PatternParameter parameter) { return described(parameter).traits; }

std::optional<double> value_of(const Pattern& pattern, PatternParameter parameter) {
    const double* number = described(parameter).at(pattern);
    if (number == nullptr) return std::nullopt;
    return *number;
}

Pattern with_value(Pattern pattern, PatternParameter parameter, double value) {
    // The pattern is ours to change.
    auto* number = const_cast<double*>(described(parameter).at(pattern));
    const Range& range = traits(parameter).range;
    if (number != nullptr) *number = std::clamp(value, range.low, range.high);
    return pattern;
}

}  // namespace tact
