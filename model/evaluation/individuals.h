// Single people: how far a metric agrees with each of them, and how far anything could.
//
// Source    bounds: Nili et al. 2014. The best metric that there could be has, with single people,
// a
//           mean rho between that of each with the mean of the others (leave one out) and that of
//           each with the mean of all (with self).
// Input     a study; of a single participant the repetitions stand for people
// Output    NaN where a rho or K is not defined, and no say in any mean
// Valid     K: of those who rated every pair; where somebody did not, a map lies anywhere
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/evaluation/evaluation.h"
#include "model/study/ratings.h"

namespace tact {

// Mean and spread of the known values.
struct Spread {
    double mean = 0.0;
    double median = 0.0;
    double low = 0.0;  // quartiles
    double high = 0.0;
    std::size_t known = 0;
};

Spread spread_of(std::span<const double> values);

// Each bounds something else, and its name says what. NaN of fewer than two voices.
struct Ceilings {
    std::size_t voices = 0;
    bool is_of_one_person = false;
    double reliability = 0.0;  // of the mean: split halves, Spearman-Brown
    double of_mean = 0.0;      // rho with the mean of these people: the square root of that
    Spread with_others;  // rho with one of them, lower bound: each with the mean of the others
    Spread with_all;     // the same, upper bound: each with the mean of all
};

Ceilings ceilings(const RatingStudy& study, const Reliability& reliability);

struct PersonAgreement {
    std::string participant;
    double with_others = 0.0;
    double with_all = 0.0;
    std::vector<double> rho;  // with each metric
    std::vector<double> k;
};

struct Individuals {
    std::vector<PersonAgreement> people;  // in the order in which they came
    std::vector<Spread> rho;              // of each metric
    std::vector<Spread> k;
};

// Empty if there is only one participant. `metrics` have the patterns of the study; `evaluations`
// are of each metric by `rated`, which brings their maps.
Individuals individuals(const RatingStudy& study, const RatedSet& rated,
                        std::span<const Dissimilarity> metrics,
                        std::span<const Evaluation> evaluations, const EvaluationParams& params);

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
