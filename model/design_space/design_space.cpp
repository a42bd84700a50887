#include "model/design_space/design_space.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "model/common/portable.h"
#include "model/pattern/pattern_numbers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// A factor's number, and where it lies in a space and in a pattern. Kind and rhythm have no number,
// mix has neither a number nor values of its own.
struct FactorTraits {
    const char* name;
    const Number* number = nullptr;
    Values DesignSpace::*values = nullptr;
    Values CarrierValues::*of_carrier = nullptr;
    double* (*at)(Pattern&, std::size_t carrier) = nullptr;
};

// clang-format off
constexpr std::array<FactorTraits, 12> kFactors{{
    {"Amplitude", &numbers::kAmplitude, &DesignSpace::amplitude_g, nullptr,
     [](Pattern& p, std::size_t) { return &p.amplitude_g; }},
    {"Carrier", &numbers::kCarrier, nullptr, &CarrierValues::frequency_hz,
     [](Pattern& p, std::size_t k) { return &p.carriers[k].frequency_hz; }},
    {"Weight", &numbers::kWeight, nullptr, &CarrierValues::weight,
     [](Pattern& p, std::size_t k) { return &p.carriers[k].weight; }},
    {"Mix", nullptr, nullptr, nullptr,
     [](Pattern& p, std::size_t) { return &p.carriers[1].weight; }},
    {"Kind"},
    {"Modulation", &numbers::kModulation, &DesignSpace::modulation_hz, nullptr,
     [](Pattern& p, std::size_t) { return &p.modulation.frequency_hz; }},
    {"Depth", &numbers::kDepth, &DesignSpace::depth, nullptr,
     [](Pattern& p, std::size_t) { return &p.modulation.depth; }},
    {"Rhythm"},
    {"Rhythm step", &numbers::kRhythmUnit, &DesignSpace::unit_s, nullptr,
     [](Pattern& p, std::size_t) { return &p.rhythm.unit_s; }},
    {"Attack", &numbers::kAttack, &DesignSpace::attack_s, nullptr,
     [](Pattern& p, std::size_t) { return &p.attack_s; }},
    {"Release", &numbers::kRelease, &DesignSpace::release_s, nullptr,
     [](Pattern& p, std::size_t) { return &p.release_s; }},
    {"Duration", &numbers::kDuration, &DesignSpace::duration_s, nullptr,
     [](Pattern& p, std::size_t) { return &p.duration_s; }}}};
// clang-format on

const FactorTraits& traits(Factor factor) {
    return kFactors[static_cast<std::size_t>(factor.parameter)];
}

std::size_t count_of(const Values& values) {
    if (const auto* levels = std::get_if<std::vector<double>>(&values)) return levels->size();
    const Span& span = std::get<Span>(values);
    return span.from == span.to ? 1 : static_cast<std::size_t>(span.steps);
}

double along(const Span& span, double share) {
    double value = span.logarithmic ? span.from * portable::pow(span.to / span.from, share)
                                    : std::lerp(span.from, span.to, share);
    if (span.multiple_of > 0.0) value = std::round(value / span.multiple_of) * span.multiple_of;
    return std::clamp(value, span.from, span.to);
}

std::size_t index_at(std::size_t count, double share) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
}

std::string fault_of(const Values& values, const Range& allowed) {
    const std::string expected =
        "numbers from " + shortest_digits(allowed.low) + " to " + shortest_digits(allowed.high);
    if (const auto* levels = std::get_if<std::vector<double>>(&values)) {
        if (levels->empty()) return "no levels, expected at least one";
        const bool good =
            std::ranges::all_of(*levels, [&](double v) { return allowed.contains(v); });
        return good ? "" : "expected " + expected;
    }
    const Span& span = std::get<Span>(values);
    if (!allowed.contains(span.from) || !allowed.contains(span.to)) return "expected " + expected;
    if (span.from > span.to) return "the range ends before it begins";
    if (span.logarithmic && span.from <= 0.0) {
        return "a range spaced in ratios must begin above 0";
    }
    return limits::kSpanSteps.contains(span.steps) ? "" : "expected 2 to 1000 steps in a range";
}

std::string factor_fault(const DesignSpace& space, Factor factor) {
    if (const Values* values = values_of(space, factor)) {
        return fault_of(*values, range_of(factor.parameter));
    }
    if (factor.parameter == Parameter::kind)
        return space.kinds.empty() ? "choose at least one" : "";
    if (space.rhythms.empty()) return "choose at least one";
    for (const std::string& text : space.rhythms) {
        const std::string fault = rhythm_fault(text);
        if (!fault.empty()) return "\"" + text + "\" is no rhythm: " + fault;
    }
    return {};
}

}  // namespace

std::vector<Factor> factors(const DesignSpace& space) {
    std::vector<Factor> all{{Parameter::amplitude}};
    for (std::size_t k = 0; k < space.carriers.size(); ++k) {
        all.push_back({Parameter::frequency, k});
        if (!space.mix) all.push_back({Parameter::weight, k});
    }
    if (space.mix) all.push_back({Parameter::mix});
    for (const Parameter parameter :
         {Parameter::kind, Parameter::modulation, Parameter::depth, Parameter::rhythm,
          Parameter::unit, Parameter::attack, Parameter::release, Parameter::duration}) {
        all.push_back({parameter});
    }
    return all;
}

std::string name_of(Factor factor) {
    const std::string name = traits(factor).name;
    const bool of_carrier =
        factor.parameter == Parameter::frequency || factor.parameter == Parameter::weight;
    return of_carrier ? name + " " + std::to_string(factor.carrier + 1) : name;
}

const Values* values_of(const DesignSpace& space, Factor factor) {
    if (factor.parameter == Parameter::mix) return space.mix ? &*space.mix : nullptr;
    const FactorTraits& of = traits(factor);
    if (of.of_carrier != nullptr) return &(space.carriers[factor.carrier].*of.of_carrier);
    return of.values == nullptr ? nullptr : &(space.*of.values);
}

Values* values_of(DesignSpace& space, Factor factor) {
    return const_cast<Values*>(values_of(static_cast<const DesignSpace&>(space), factor));
}

Range range_of(Parameter parameter) {
    if (parameter == Parameter::mix) return limits::kMix;
    const Number* number = traits({parameter}).number;
    assert(number != nullptr && "a parameter without numbers");
    return number->range;
}

std::size_t level_count(const DesignSpace& space, Factor factor) {
    if (factor.parameter == Parameter::kind) return space.kinds.size();
    if (factor.parameter == Parameter::rhythm) return space.rhythms.size();
    return count_of(*values_of(space, factor));
}

double value_at(const Values& values, double share) {
    if (const auto* levels = std::get_if<std::vector<double>>(&values)) {
        return (*levels)[index_at(levels->size(), share)];
    }
    return along(std::get<Span>(values), share);
}

void set_value(Pattern& pattern, const DesignSpace& space, Factor factor, double share) {
    if (factor.parameter == Parameter::kind) {
        pattern.modulation.kind = space.kinds[index_at(space.kinds.size(), share)];
        return;
    }
    if (factor.parameter == Parameter::rhythm) {
        pattern.rhythm.text = space.rhythms[index_at(space.rhythms.size(), share)];
        return;
    }
    const double value = value_at(*values_of(space, factor), share);
    if (factor.parameter == Parameter::mix) pattern.carriers[0].weight = 1.0 - value;
    *traits(factor).at(pattern, factor.carrier) = value;
}

double combination_count(const DesignSpace& space) {
    if (space.design != Design::factorial) return space.samples;
    double count = 1.0;
    for (const Factor factor : factors(space))
        count *= static_cast<double>(level_count(space, factor));
    return count;
}

std::string design_fault(const DesignSpace& space) {
    if (space.carriers.empty() || space.carriers.size() > limits::kMaxCarriers) {
        return "expected 1 to " + std::to_string(limits::kMaxCarriers) + " carriers";
    }
    if (space.mix && space.carriers.size() != 2) {
        return "mix is the share of the second of two carriers, and there are not two";
    }
    for (const Factor factor : factors(space)) {
        const std::string fault = factor_fault(space, factor);
        if (!fault.empty()) return name_of(factor) + ": " + fault;
    }
    if (space.design != Design::factorial && !limits::kSamples.contains(space.samples)) {
        return "expected 1 to " + grouped_digits(limits::kMaxPatterns) + " samples";
    }
    const auto& band = space.constraints.band_hz;
    if (band && band->low > band->high) return "device band: it ends before it begins";
    const double count = combination_count(space);
    if (count > static_cast<double>(limits::kMaxPatterns)) {
        const std::string number =
            count < 1e15 ? grouped_digits(static_cast<std::size_t>(count)) : "more than 10^15";
        return "the full factorial has " + number + " combinations, at most " +
               grouped_digits(limits::kMaxPatterns) + " can be made: use fewer levels, or a sample";
    }
    return {};
}

}  // namespace tact
