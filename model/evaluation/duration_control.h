// What a metric says of people's ratings beyond how long the patterns last: length alone may carry
// an agreement, and a metric that is blind to it may still know the rest.
//
// Source    partial rank correlation: Kendall 1942. The pairs of equal length are a check without a
//           model of how length acts.
// Input     dissimilarities of a metric and of people, and how long each pattern sounds, s
// Valid     lengths equal to the sample are equal
// Left out  other nuisances, such as level.
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/signal/waveform.h"

namespace tact {

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
