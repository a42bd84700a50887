#include "model/design_space/candidates.h"

#include <algorithm>
#include <utility>

#include "model/common/random.h"
#include "model/design_space/sobol.h"
#include "model/design_space/spectral_lines.h"
#include "model/pattern/same_vibration.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// How far every combination is along each factor, 0 to 1.
using Shares = std::vector<std::vector<double>>;

// Levels lie in the middle of equal parts of the way; a range's steps have its ends among them.
double share_of_level(const DesignSpace& space, Factor factor, std::size_t level,
                      std::size_t count) {
    const Values* values = values_of(space, factor);
    if (values != nullptr && std::holds_alternative<Span>(*values)) {
        return static_cast<double>(level) / static_cast<double>(count - 1);
    }
    return (static_cast<double>(level) + 0.5) / static_cast<double>(count);
}

Shares factorial(const DesignSpace& space, const std::vector<Factor>& varied) {
    const auto size = static_cast<std::size_t>(combination_count(space));
    Shares shares(size, std::vector<double>(varied.size()));
    std::size_t repeats = 1;  // of a level, one after the other
    for (std::size_t k = varied.size(); k-- > 0;) {
        const std::size_t count = level_count(space, varied[k]);
        for (std::size_t i = 0; i < size; ++i) {
            shares[i][k] = share_of_level(space, varied[k], i / repeats % count, count);
        }
        repeats *= count;
    }
    return shares;
}

Shares latin_hypercube(const DesignSpace& space, std::size_t dimensions) {
    const auto size = static_cast<std::size_t>(space.samples);
    Shares shares(size, std::vector<double>(dimensions));
    std::vector<std::size_t> order(size);
    for (std::size_t k = 0; k < dimensions; ++k) {
        RandomStream random{random_bits(static_cast<std::uint64_t>(space.seed), k)};
        next_permutation_of(random, order);
        for (std::size_t i = 0; i < size; ++i) {
            const double within = 0.5 + 0.5 * next_even(random);
            shares[i][k] = (static_cast<double>(order[i]) + within) / static_cast<double>(size);
        }
    }
    return shares;
}

Shares sobol(const DesignSpace& space, std::size_t dimensions) {
    Shares shares(static_cast<std::size_t>(space.samples), std::vector<double>(dimensions));
    for (std::size_t k = 0; k < dimensions; ++k) {
        const std::uint64_t bits = random_bits(static_cast<std::uint64_t>(space.seed), k) >> 32U;
        const auto shift = space.seed == 0 ? 0U : static_cast<std::uint32_t>(bits);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            shares[i][k] = sobol_coordinate(static_cast<std::uint32_t>(i), k, shift);
        }
    }
    return shares;
}

Shares shares_of(const DesignSpace& space, const std::vector<Factor>& varied) {
    switch (space.design) {
        case Design::latin_hypercube:
            return latin_hypercube(space, varied.size());
        case Design::sobol:
            return sobol(space, varied.size());
        case Design::factorial:
            break;
    }
    return factorial(space, varied);
}

std::string joined(const Pattern& pattern, double Carrier::*field, const char* between) {
    std::string text;
    for (const Carrier& carrier : pattern.carriers) {
        text += (text.empty() ? "" : between) + significant_digits(carrier.*field, 4);
    }
    return text;
}

std::string word_of(const Pattern& pattern, Factor factor) {
    const Modulation& modulation = pattern.modulation;
    switch (factor.parameter) {
        case Parameter::amplitude:
            return significant_digits(pattern.amplitude_g, 4) + " g";
        case Parameter::frequency:
            return joined(pattern, &Carrier::frequency_hz, "+") + " Hz";
        case Parameter::weight:
            return "w " + joined(pattern, &Carrier::weight, ":");
        case Parameter::mix:
            return "mix " + significant_digits(pattern.carriers[1].weight, 4);
        case Parameter::kind:
            return modulation.kind == ModulationKind::am ? "tremolo" : "ring";
        case Parameter::modulation:
            return "mod " + significant_digits(modulation.frequency_hz, 4) + " Hz";
        case Parameter::depth:
            return "depth " + significant_digits(modulation.depth, 4);
        case Parameter::rhythm:
            return pattern.rhythm.text.empty() ? "steady" : pattern.rhythm.text;
        case Parameter::unit:
            return "step " + significant_digits(1000.0 * pattern.rhythm.unit_s, 4) + " ms";
        case Parameter::attack:
            return "attack " + significant_digits(1000.0 * pattern.attack_s, 4) + " ms";
        case Parameter::release:
            return "release " + significant_digits(1000.0 * pattern.release_s, 4) + " ms";
        case Parameter::duration:
            return significant_digits(pattern.duration_s, 4) + " s";
    }
    return {};
}

// A word for every parameter that varies; one for all carriers.
std::string name_of(const Pattern& pattern, const std::vector<Factor>& varied) {
    std::string name;
    bool has_frequency = false;
    bool has_weight = false;
    for (const Factor factor : varied) {
        if (factor.parameter == Parameter::frequency && std::exchange(has_frequency, true))
            continue;
        if (factor.parameter == Parameter::weight && std::exchange(has_weight, true)) continue;
        name += (name.empty() ? "" : " ") + word_of(pattern, factor);
    }
    return name.empty() ? "candidate" : name;
}

// Counts the first constraint that the pattern fails; null: it keeps to all.
std::size_t* failed(const Pattern& pattern, const Constraints& constraints,
                    const PhysiologyTables& tables, Rejections& rejected) {
    const std::vector<SpectralLine> lines = spectral_lines(pattern);
    const auto& band = constraints.band_hz;
    const auto outside = [&band](const SpectralLine& l) { return !band->contains(l.frequency_hz); };
    if (band && std::ranges::any_of(lines, outside)) return &rejected.band;
    if (constraints.displacement_um && most_displacement_um(lines) > *constraints.displacement_um) {
        return &rejected.displacement;
    }
    if (constraints.detectable_db) {
        const auto above_db = detectability_db(lines, tables);
        if (!above_db || *above_db < *constraints.detectable_db) return &rejected.detectability;
    }
    return nullptr;
}

}  // namespace

std::size_t total(const Rejections& rejected) {
    return rejected.band + rejected.displacement + rejected.detectability;
}

std::string level_words(const DesignSpace& space, const Pattern& pattern) {
    std::vector<Factor> varied;
    for (const Factor factor : factors(space)) {
        const bool has_it = factor.parameter == Parameter::mix ? pattern.carriers.size() > 1 : true;
        if (level_count(space, factor) > 1 && has_it) varied.push_back(factor);
    }
    return name_of(pattern, varied);
}

Expected<Candidates> candidates(const DesignSpace& space, const PhysiologyTables& tables,
                                std::stop_token stop) {
    if (std::string fault = design_fault(space); !fault.empty()) return Error{fault};
    const std::vector<Factor> all = factors(space);
    std::vector<Factor> varied;
    std::ranges::copy_if(all, std::back_inserter(varied),
                         [&](Factor factor) { return level_count(space, factor) > 1; });
    Pattern base;
    base.carriers.resize(space.carriers.size());
    for (const Factor factor : all) set_value(base, space, factor, 0.0);

    Candidates result;
    SeenVibrations seen;
    UnusedNames names;
    for (const std::vector<double>& shares : shares_of(space, varied)) {
        if (stop.stop_requested()) return result;
        Pattern pattern = base;
        for (std::size_t k = 0; k < varied.size(); ++k) {
            set_value(pattern, space, varied[k], shares[k]);
        }
        ++result.combinations;
        if (!seen.add(pattern)) {
            ++result.doubles;
        } else if (std::size_t* count =
                       failed(pattern, space.constraints, tables, result.rejected)) {
            ++*count;
        } else {
            result.kept.push_back({names.unused(name_of(pattern, varied)), std::move(pattern)});
        }
    }
    return result;
}

}  // namespace tact
