#include "model/pattern/pattern_parameter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

// What is felt of a change (model/pattern/felt_steps.h has the sources). `first` and `least`: of
// what goes by ratio.
struct FeltChange {
    bool by_ratio;
    double step;
    const char* source;
    bool is_guess = false;
    double first = 0.0;
    double least = 0.0;
};

constexpr double kDecibels15 = 1.188502227437019;  // 1.5 dB as a factor
constexpr const char* kIsrar = "Israr, Tan & Reed 2006";
constexpr const char* kOurs = "ours";
constexpr FeltChange kFeltAmplitude{true, kDecibels15, "Craig 1972, as cited", false, 0.05, 0.001};
constexpr FeltChange kFeltFrequency{true, 1.2, kIsrar};
constexpr FeltChange kFeltModulation{true, 1.2, "as of a carrier", true, 1.0, 1.0};
constexpr FeltChange kFeltShare{false, 0.2, kOurs, true};
constexpr FeltChange kFeltUnit{true, 1.16, "Jones, Poliakoff & Wells 2009"};
constexpr FeltChange kFeltRamp{false, 0.03, "Remache-Vinueza et al. 2025, of pulses", true};

// A parameter by the number that it is, and where a pattern has it; null where it has none.
struct DescribedParameter {
    PatternParameter parameter;
    ParameterTraits traits;
    const double* (*at)(const Pattern&);
};

constexpr ParameterTraits of(const char* key, const char* name, const char* unit,
                             const Number& number, const FeltChange& felt) {
    return {.key = key,
            .name = name,
            .unit = unit,
            .range = number.range,
            .slider = number.slider,
            .by_ratio = felt.by_ratio,
            .first = felt.first,
            .least = felt.least,
            .step = felt.step,
            .step_source = felt.source,
            .step_is_guess = felt.is_guess};
}

const Carrier* second_of(const Pattern& p) {
    return p.carriers.size() > 1 ? &p.carriers[1] : nullptr;
}

// clang-format off
constexpr auto kParameters = std::to_array<DescribedParameter>({
    {PatternParameter::amplitude, of("amplitude_g", "amplitude", "g", numbers::kAmplitude, kFeltAmplitude),
     [](const Pattern& p) { return &p.amplitude_g; }},
    {PatternParameter::carrier, of("carrier_hz", "carrier", "Hz", numbers::kCarrier, kFeltFrequency),
     // A drawn frequency is no number.
     [](const Pattern& p) { return p.carriers.empty() || !p.frequency_curve.empty() ? nullptr : &p.carriers[0].frequency_hz; }},
    {PatternParameter::second_carrier, of("second_carrier_hz", "second carrier", "Hz", numbers::kCarrier, kFeltFrequency),
     [](const Pattern& p) { return second_of(p) == nullptr ? nullptr : &second_of(p)->frequency_hz; }},
    {PatternParameter::mix, of("mix", "weight of the second carrier", "", numbers::kWeight, kFeltShare),
     [](const Pattern& p) { return second_of(p) == nullptr ? nullptr : &second_of(p)->weight; }},
    {PatternParameter::modulation, of("modulation_hz", "modulation", "Hz", numbers::kModulation, kFeltModulation),
     [](const Pattern& p) { return &p.modulation.frequency_hz; }},
    {PatternParameter::depth, of("depth", "depth", "", numbers::kDepth, kFeltShare),
     [](const Pattern& p) { return p.modulation.kind == ModulationKind::am ? &p.modulation.depth : nullptr; }},
    {PatternParameter::rhythm_unit, of("rhythm_unit_s", "rhythm unit", "s", numbers::kRhythmUnit, kFeltUnit),
     [](const Pattern& p) { return p.rhythm.text.empty() ? nullptr : &p.rhythm.unit_s; }},
    {PatternParameter::attack, of("attack_s", "attack", "s", numbers::kAttack, kFeltRamp),
     [](const Pattern& p) { return &p.attack_s; }},
    {PatternParameter::release, of("release_s", "release", "s", numbers::kRelease, kFeltRamp),
     [](const Pattern& p) { return &p.release_s; }}});
// clang-format on

constexpr bool is_row_of_each() {
    if (kParameters.size() != kPatternParameters.size()) return false;
    for (std::size_t k = 0; k < kParameters.size(); ++k) {
        if (kParameters[k].parameter != kPatternParameters[k]) return false;
    }
    return true;
}
static_assert(is_row_of_each(), "expected a row for each parameter, in the order of the enum");

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
