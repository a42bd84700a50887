// Each participant's weights of the dimensions of one common map.
//
// Source    INDSCAL: Carroll & Chang 1970 (Psychometrika 35, 283-319), by alternating least squares
//           on scalar products; weights not below 0. Unlike those of other maps its dimensions must
//           not be turned: they are those along which people differ.
// Input     a study; each one's mean over repetitions, of the patterns that anybody rated
// Output    the common map, n x k, centred, each column with a sum of squares of 1; columns by how
//           much all weigh them, the farthest pattern of each on the positive side
// Valid     at least two people who rated every pair of at least k + 2 patterns; otherwise empty
// Left out  an additive constant, ordinal ratings, tests: weights are descriptions
// Exact     same input, same bits.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "model/study/ratings.h"

namespace tact {

inline constexpr int kMostWeightedDimensions = 5;

struct PersonWeights {
    std::string participant;
    // Part of their ratings in each dimension; 0: none. Comparable between people, since everyone's
    // scalar products are scaled to a sum of squares of 1.
    std::vector<double> weights;
    double explained = 0.0;  // share of that sum, 0 to 1
};

struct IndividualWeights {
    std::vector<std::string> labels;
    Eigen::MatrixXd group;
    std::vector<PersonWeights> people;  // in the order in which they came
    std::vector<double> mean;           // of their weights
    std::vector<std::string> left_out;  // who did not rate every pair, or all alike
    double explained = 0.0;             // mean over people
};

// `starts` random ones besides that of the mean; the best counts, of equals the first.
IndividualWeights individual_weights(const RatingStudy& study, int dimensions, int starts = 20,
                                     std::uint64_t seed = 1);

// The patterns that lie farthest to either side of a dimension.
struct DimensionEnds {
    std::string low;
    std::string high;
};
DimensionEnds ends_of(const IndividualWeights& weights, std::size_t dimension);

// What the program shows: three, as of other maps, fewer of few patterns; none of fewer than three.
int shown_weight_dimensions(std::size_t patterns);

}  // namespace tact
