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

}  // namespace tact
