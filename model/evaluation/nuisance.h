// What a metric says of people's ratings beyond something simple that may carry the agreement
// alone: how long patterns last, how strong they are, or any matrix of one's own.
//
// Source    partial rank correlation: Kendall 1942; interval by standard error over drawn patterns
// Input     dissimilarities of the patterns of the ratings; NaN pairs are left out
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/dissimilarity/correlation.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"
#include "model/signal/waveform.h"

namespace tact {

// "duration": how much longer one sounds than the other, s; "level": by how many dB it is stronger.
// None of another name.
std::optional<Dissimilarity> nuisance_named(std::string_view name, const PatternSet& set);

struct PartialRho {
    double rho = 0.0;  // NaN: none, or nothing is left
    Interval interval;
};

struct Given {
    std::string name;
    double rho_alone = 0.0;  // of the nuisance itself with the ratings
    std::vector<PartialRho> metrics;
};

Given given(const std::string& name, const Dissimilarity& nuisance, const Dissimilarity& ratings,
            const std::vector<Dissimilarity>& metrics, const BootstrapParams& params = {});

// What a metric says of people's ratings beyond how long the patterns last: length alone may carry
// an agreement, and a metric that is blind to it may still know the rest.
//
// Source    partial rank correlation: Kendall 1942. The pairs of equal length are a check without a
//           model of how length acts.
// Input     dissimilarities of a metric and of people, and how long each pattern sounds, s
// Valid     lengths equal to the sample are equal
// Left out  other nuisances, such as level.
// Exact     same input, same bits.

// From the begin to the last sample that is not 0, s; 0 of silence.
double sounding_s(const Waveform& waveform);

struct DurationControl {
    std::size_t equal_pairs = 0;  // that sound equally long, and are rated
    double rho_of_equal = 0.0;    // Spearman's, over these; NaN: no order
    double partial_rho = 0.0;     // over all pairs, given the differences of length
    double rho_of_length = 0.0;   // of these differences alone
};

// The three are of the same patterns; NaN ratings are left out.
DurationControl duration_control(const Dissimilarity& metric, const Dissimilarity& ratings,
                                 std::span<const double> lasting_s);

// How many values its pairs have, rounded as they are for ranks.
std::size_t distinct_values(const Dissimilarity& matrix);

}  // namespace tact
