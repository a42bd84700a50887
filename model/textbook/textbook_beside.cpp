#include "model/textbook/textbook_beside.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "model/physiology/firing.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

using Facts = std::vector<BesideFact>;

constexpr double kMm2OfCm2 = 100.0;
constexpr double kLowestHz = 1.0;
constexpr double kHighestHz = 500.0;
constexpr double kSame = 1e-9;

bool fires(const BesideInput& input, Receptor receptor) {
    return input.firing[index_of(receptor)] == Firing::fires;
}

// Impulses/s of the receptor under the probe.
double fired_hz(const BesideInput& input, Receptor receptor) {
    const auto counts = spikes_under_probe(input.stages.channel[index_of(receptor)]);
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    const double whole_s = duration_s(input.waveform);
    return whole_s > 0.0 ? sum / whole_s : 0.0;
}

double lowest_db(const PhysiologyTables& tables, double hz) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Curve& curve : tables.threshold) lowest = std::min(lowest, at(curve, hz));
    return 20.0 * lowest;
}

// The frequency at which the lowest of some curves has its minimum, always a knot; for a flat
// stretch, its middle on a log scale.
double lowest_at_hz(std::span<const Curve> curves) {
    double least = std::numeric_limits<double>::infinity();
    double from = 0.0;
    double to = 0.0;
    for (const Curve& curve : curves) {
        for (const double hz : curve.frequency_hz) {
            if (hz < kLowestHz || hz > kHighestHz) continue;
            double value = std::numeric_limits<double>::infinity();
            for (const Curve& other : curves) value = std::min(value, at(other, hz));
            if (value < least - kSame) from = to = hz;
            least = std::min(least, value);
            if (value > least + kSame) continue;
            from = std::min(from, hz);
            to = std::max(to, hz);
        }
    }
    return std::sqrt(from * to);
}

std::optional<double> strongest_hz(const BesideInput& input) {
    const auto& all = input.stages.components;
    const auto most = std::ranges::max_element(all, {}, &Component::amplitude_g);
    if (most == all.end() || !(most->amplitude_g > 0.0)) return std::nullopt;
    return most->frequency_hz;
}

bool is_within(const TextbookFact& fact, double value) {
    return (!fact.low || value >= *fact.low) && (!fact.high || value <= *fact.high);
}

// ---- spikes ----

void add_cycles(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    for (const Receptor receptor : kReceptors) {
        if (!fires(input, receptor)) continue;
        const double times = impulses_a_cycle(input.stages, receptor);
        if (times <= 0.0) continue;
        facts.push_back({&fact, receptor, {}, {}, times, times > kManyACycle});
    }
}

// For facts measured with single tones: a type's strong components lie within an octave.
void add_highest_rate(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    const Receptor receptor = *fact.receptor;
    const auto band = strong_band_hz(input.stages, receptor);
    if (!fires(input, receptor) || !band || band->high > 2.0 * band->low) return;
    const double hz = std::sqrt(band->low * band->high);
    const auto measured = value_over(fact, hz);
    if (!measured) return;
    const double rate_hz = fired_hz(input, receptor);
    facts.push_back(
        {&fact, receptor, hz, measured, rate_hz, rate_hz > (1.0 + kRateSlack) * *measured});
}

void add_of_firing(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    if (fact.id == "impulses a cycle") return add_cycles(input, fact, facts);
    if (fact.id.starts_with("highest rate")) return add_highest_rate(input, fact, facts);
    if (!fact.receptor || !fires(input, *fact.receptor)) return;
    // The model's rate is constant while the vibration is.
    if (fact.id.starts_with("adaptation")) {
        facts.push_back({&fact, fact.receptor, {}, {}, 0.0, true});
    }
    if (fact.id == "ruffini found") facts.push_back({&fact, fact.receptor, {}, {}, {}, true});
}

// ---- receptors ----

void add_density(const TextbookFact& fact, Facts& facts) {
    double model = 0.0;
    for (const Receptor receptor : kReceptors) {
        if (fact.receptor.value_or(receptor) == receptor) {
            model += traits(receptor).density_per_mm2;
        }
    }
    if (!fact.unit.ends_with("/mm\u00b2")) model *= kMm2OfCm2;
    const bool parts = fact.low && fact.high
                           ? std::abs(model - *fact.low) > kDensitySlack * *fact.low
                           : !is_within(fact, model);
    facts.push_back({&fact, fact.receptor, {}, {}, model, parts});
}

void add_share(const TextbookFact& fact, Facts& facts) {
    double all = 0.0;
    for (const Receptor receptor : kReceptors) all += traits(receptor).density_per_mm2;
    const double model = 100.0 * traits(*fact.receptor).density_per_mm2 / all;
    facts.push_back({&fact, fact.receptor, {}, {}, model, !is_within(fact, model)});
}

void add_of_skin(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    if (fact.id.find("density") != std::string::npos) return add_density(fact, facts);
    if (fact.id.starts_with("share of")) return add_share(fact, facts);
    add_of_firing(input, fact, facts);
}

// ---- spectrum ----

void add_of_spectrum(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    const auto lowest = [&](double hz) { return lowest_db(input.tables, hz); };
    const std::optional<double> strongest = strongest_hz(input);
    if (fact.id.starts_with("best band")) {
        const Curve& curve = input.tables.threshold[index_of(*fact.receptor)];
        const double best = lowest_at_hz({&curve, 1});
        facts.push_back({&fact, fact.receptor, {}, {}, best, !is_within(fact, best)});
    } else if (fact.id == "most sensitive at") {
        const double best = lowest_at_hz(input.tables.threshold);
        facts.push_back({&fact, {}, {}, {}, best, !is_within(fact, best)});
    } else if (fact.id == "fall of the threshold") {
        const double fall = (lowest(40.0) - lowest(250.0)) / std::log2(250.0 / 40.0);
        facts.push_back({&fact, {}, {}, {}, fall, std::abs(fall - *fact.low) > 3.0});
    } else if (fact.id == "least amplitude felt" && strongest) {
        const auto measured = value_over(fact, *strongest);
        if (!measured) return;
        const double model = lowest(*strongest);
        const bool parts = std::abs(model - *measured) > kThresholdSlackDb;
        facts.push_back({&fact, {}, strongest, measured, model, parts});
    } else if (fact.id == "flutter" && strongest && is_within(fact, *strongest)) {
        facts.push_back({&fact, {}, {}, {}, {}, false});
    }
}

// ---- networks, central signals, brain ----

void add_of_brain(const BesideInput& input, const TextbookFact& fact, Facts& facts) {
    if (!strongest_hz(input)) return;
    if (fact.id == "convergence") {
        // Each type has a network of its own, up to the weighted sum.
        facts.push_back({&fact, {}, {}, {}, 0.0, true});
    } else if (fact.id == "phase locking") {
        // Spikes are spread evenly within a step, so periods below two steps are not in them.
        const double model = 0.5 / kStepS;
        facts.push_back({&fact, {}, {}, {}, model, model < *fact.low});
    } else {
        facts.push_back({&fact, {}, {}, {}, {}, false});
    }
}

// ---- words ----

std::string measured_text(const BesideFact& beside) {
    const TextbookFact& fact = *beside.fact;
    const std::string name =
        fact.receptor ? std::string(traits(*fact.receptor).name) + " " : std::string();
    if (beside.measured) return name + significant_digits(*beside.measured, 3);
    if (!fact.high) return name + "at least " + significant_digits(*fact.low, 3);
    if (!fact.low) return name + "less than " + significant_digits(*fact.high, 3);
    if (*fact.low == *fact.high) return name + significant_digits(*fact.low, 3);
    return name + significant_digits(*fact.low, 3) + " to " + significant_digits(*fact.high, 3);
}

bool share_a_line(const BesideFact& a, const BesideFact& b) {
    return a.fact->cite == b.fact->cite && a.fact->unit == b.fact->unit &&
           a.fact->what == b.fact->what && a.fact->species == b.fact->species &&
           a.model.has_value() && b.model.has_value() &&
           a.fact->points.empty() == b.fact->points.empty();
}

BesideLine line_of(const std::vector<const BesideFact*>& group) {
    const BesideFact& first = *group.front();
    BesideLine line;
    for (const BesideFact* one : group) line.parts = line.parts || one->parts;
    if (!first.model) {
        line.text = sentence_of(*first.fact);
        return line;
    }
    std::string measured;
    std::string here;
    for (const BesideFact* one : group) {
        const bool is_known = one != group.front() && one->fact == first.fact;
        if (!is_known) measured += (measured.empty() ? "" : ", ") + measured_text(*one);
        const bool is_named = one->receptor && !one->fact->receptor;
        here += here.empty() ? "" : ", ";
        if (is_named) here += std::string(traits(*one->receptor).name) + " ";
        here += significant_digits(*one->model, 3);
    }
    line.text = first.fact->what + ": " + measured + " " + first.fact->unit;
    if (first.at_hz && !first.fact->receptor)
        line.text += " at " + significant_digits(*first.at_hz, 3) + " Hz";
    line.text += " (" + source_text(*first.fact) + "); here " + here;
    return line;
}

}  // namespace

std::vector<BesideFact> beside_the_model(std::string_view stage, const BesideInput& input) {
    Facts facts;
    for (const TextbookFact& fact : textbook()) {
        if (fact.sure == Sure::from_memory) continue;
        if (std::ranges::find(fact.stages, stage) == fact.stages.end()) continue;
        if (stage == "spectrum") {
            add_of_spectrum(input, fact, facts);
        } else if (stage == "receptors") {
            add_of_skin(input, fact, facts);
        } else if (stage == "spikes") {
            add_of_firing(input, fact, facts);
        } else {
            add_of_brain(input, fact, facts);
        }
    }
    return facts;
}

std::vector<BesideFact> where_the_model_parts(std::string_view stage, const BesideInput& input) {
    Facts facts = beside_the_model(stage, input);
    std::erase_if(facts, [](const BesideFact& one) { return !one.parts; });
    return facts;
}

std::vector<BesideLine> lines_of(const std::vector<BesideFact>& facts) {
    std::vector<std::vector<const BesideFact*>> groups;
    for (const BesideFact& one : facts) {
        const auto group = std::ranges::find_if(
            groups, [&](const auto& other) { return share_a_line(*other.front(), one); });
        if (group == groups.end()) {
            groups.push_back({&one});
        } else {
            group->push_back(&one);
        }
    }
    std::vector<BesideLine> lines;
    for (const auto& group : groups) lines.push_back(line_of(group));
    std::ranges::stable_sort(
        lines, [](const BesideLine& a, const BesideLine& b) { return a.parts && !b.parts; });
    return lines;
}

}  // namespace tact
