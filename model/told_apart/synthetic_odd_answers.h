// A simulated person in odd-one-out trials, for tests and for looking at the program without a
// phone.
//
// Source    threshold_posterior.h, whose share of right answers it has; who errs takes either of
//           the other two places
// Exact     same person and trial, same answer, on any processor
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "model/told_apart/odd_trials.h"

namespace tact {

struct SyntheticAnswerer {
    double threshold_pm = 10.0;  // infinite: guesses
    double slope = 3.0;          // of the logistic function of ln PM
    std::uint64_t seed = 1;
};

inline constexpr double kNeverToldApart = std::numeric_limits<double>::infinity();

// The place that is taken for the odd one. `serial`: of the trial.
int synthetic_place(const SyntheticAnswerer& person, const OddOneOut& trial, std::uint64_t serial);

// All trials of a design, answered; marked as synthetic, without versions of the patterns.
ToldApart synthetic_trials(const SyntheticAnswerer& person, const TrialDesign& design);

}  // namespace tact
