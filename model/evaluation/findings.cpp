#include "model/evaluation/findings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <variant>

#include "assets/assets.h"
#include "model/common/decompositions.h"
#include "model/map/mds.h"
#include "model/map/random_stress.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

struct Outcome {
    FindingStatus status;
    std::string evidence;
};

Outcome decided(bool holds, const std::string& evidence) {
    return {holds ? FindingStatus::holds : FindingStatus::fails, evidence};
}

std::string rounded(double value) { return shortest_digits(std::round(value * 1000.0) / 1000.0); }

const Pattern& pattern(const PatternSet& set, std::size_t k) {
    return std::get<Pattern>(set.vibrations[k].source);
}

double modulation_hz(const PatternSet& set, std::size_t k) {
    return pattern(set, k).modulation.frequency_hz;
}

struct Range {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
};

void include(Range& range, double value) {
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
}

// Distances from the unmodulated vibration: to those at 40 and 80 Hz, and to the slower ones.
std::pair<Range, Range> fast_and_slow(const PredictedSet& am) {
    std::pair<Range, Range> ranges;
    std::size_t plain = 0;
    while (modulation_hz(am.set, plain) != 0.0) ++plain;
    for (std::size_t k = 0; k < am.pm.size; ++k) {
        if (k == plain) continue;
        include(modulation_hz(am.set, k) >= 40.0 ? ranges.first : ranges.second, am.pm(plain, k));
    }
    return ranges;
}

Outcome fast_modulation_is_like_none(const KnownSets& sets) {
    bool holds = true;
    std::string evidence;
    for (const auto& [reading, am] :
         {std::pair{"4 Hz", &sets.am_4hz}, std::pair{"5 Hz", &sets.am_5hz}}) {
        const auto [fast, slow] = fast_and_slow(*am);
        holds = holds && fast.most < slow.least;
        evidence += (evidence.empty() ? "" : "; ") + std::string("with ") + reading +
                    ": PM to 40 and 80 Hz at most " + rounded(fast.most) +
                    ", to slower ones at least " + rounded(slow.least);
    }
    return decided(holds, evidence);
}

// Share of the variance of `values` that a plane over some columns explains.
double explained(const Eigen::VectorXd& values, const Eigen::MatrixXd& columns) {
    const Eigen::VectorXd centred = values.array() - values.mean();
    const Eigen::MatrixXd axes = columns.rowwise() - columns.colwise().mean();
    const Eigen::VectorXd fit =
        axes * solved_symmetric(axes.transpose() * axes, axes.transpose() * centred);
    return 1.0 - (centred - fit).squaredNorm() / centred.squaredNorm();
}

Outcome axes_are_modulation_and_amplitude(const KnownSets& sets) {
    const PatternSet& set = sets.twelve.set;
    const Eigen::MatrixXd points =
        nonmetric_mds(sets.twelve.pm, standard_mds_params(sets.twelve.pm.size, 3)).points;
    Eigen::VectorXd modulation(points.rows());
    Eigen::VectorXd amplitude(points.rows());
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        modulation(k) = modulation_hz(set, static_cast<std::size_t>(k));
        amplitude(k) = pattern(set, static_cast<std::size_t>(k)).amplitude_g;
    }
    const double modulation_12 = explained(modulation, points.leftCols(2));
    const double modulation_3 = explained(modulation, points.rightCols(1));
    const double amplitude_12 = explained(amplitude, points.leftCols(2));
    const double amplitude_3 = explained(amplitude, points.rightCols(1));
    // An axis is aligned with what it explains more than half of.
    return decided(modulation_12 > 0.5 && amplitude_3 > 0.5,
                   "in the predicted space (the finding is about people's), D1 and D2 explain " +
                       rounded(modulation_12) + " of the variance of modulation frequency, D3 " +
                       rounded(modulation_3) + "; of amplitude D1 and D2 " + rounded(amplitude_12) +
                       ", D3 " + rounded(amplitude_3));
}

Outcome clusters_are_closer_within(const KnownSets& sets) {
    const PatternSet& set = sets.twelve.set;
    std::array<double, 2> sum{};
    std::array<double, 2> count{};
    for (std::size_t i = 0; i < sets.twelve.pm.size; ++i) {
        for (std::size_t j = i + 1; j < sets.twelve.pm.size; ++j) {
            const bool within = modulation_hz(set, i) == modulation_hz(set, j) &&
                                pattern(set, i).amplitude_g == pattern(set, j).amplitude_g;
            const std::size_t which = within ? 0 : 1;
            sum[which] += sets.twelve.pm(i, j);
            count[which] += 1.0;
        }
    }
    const double within = sum[0] / count[0];
    const double between = sum[1] / count[1];
    return decided(within < between, "mean PM within clusters " + rounded(within) +
                                         ", between them " + rounded(between) +
                                         " (rank sums of 66 pairs)");
}

Outcome space_fits_well(const KnownSets& sets) {
    const std::size_t n = sets.twelve.pm.size;
    RandomStressParams random;
    random.draws = 40;  // a mean to .003
    const double stress = nonmetric_mds(sets.twelve.pm, standard_mds_params(n, 3)).stress1;
    return decided(stress < 0.05, "the predicted space of the twelve has stress-1 " +
                                      rounded(stress) + "; of random orders " +
                                      rounded(random_stress(n, 3, random).mean));
}

Outcome needs_ratings(const KnownSets& /*sets*/) {
    return {FindingStatus::needs_ratings, "the ratings it is about are not public"};
}

Outcome needs_stimuli(const KnownSets& /*sets*/) {
    return {FindingStatus::needs_stimuli, "the exact vibrations are not public"};
}

struct Check {
    std::string_view id;
    Outcome (*outcome)(const KnownSets&);
};

constexpr Check kChecks[] = {{"AM-1", fast_modulation_is_like_none},
                             {"AM-2", needs_ratings},
                             {"FA-1", needs_stimuli},
                             {"FA-2", needs_stimuli},
                             {"FA-3", needs_stimuli},
                             {"FA-4", needs_ratings},
                             {"DF-1", needs_stimuli},
                             {"DF-2", needs_ratings},
                             {"DF-3", needs_ratings},
                             {"OWN-1", axes_are_modulation_and_amplitude},
                             {"OWN-2", clusters_are_closer_within},
                             {"OWN-3", needs_ratings},
                             {"RH-1", needs_stimuli},
                             {"RH-2", needs_stimuli},
                             {"RH-3", needs_stimuli},
                             {"GEN-1", space_fits_well}};

std::string_view without_head(std::string_view text) {
    while (text.starts_with('#')) text.remove_prefix(text.find('\n') + 1);
    return text;
}

}  // namespace

std::vector<Finding> findings(const KnownSets& sets) {
    CsvReader reader{without_head(asset("reference/qualitative_checks.csv"))};
    next_record(reader);  // names of the columns
    std::vector<Finding> all;
    for (CsvRecord record = next_record(reader); record.line != 0; record = next_record(reader)) {
        assert(record.fields.size() == 5 && "id, set, check, source, conf");
        const auto check = std::ranges::find(kChecks, record.fields[0], &Check::id);
        assert(check != std::end(kChecks) && "a check for every finding");
        Outcome outcome = check->outcome(sets);
        all.push_back({record.fields[0], record.fields[1], record.fields[2], record.fields[3],
                       outcome.status, std::move(outcome.evidence)});
    }
    return all;
}

}  // namespace tact
