// Which pair is asked next, and in which order it is played.
//
// Source    the pair whose answer is expected to say most of the threshold (Kontsevich & Tyler
//           1999, psi; of the threshold alone: Prins 2013). Equals are drawn by the seed. Places of
//           the odd one and which of the two it is: blocks of six, each block in an order of its
//           own, so that whoever always taps one place is right in a third of the trials.
// Input     the design, and the answers so far in their order
// Valid     pairs of PM above 0; no pair is asked more often in a row than its share of the trials,
//           from once to three times, unless there is no other
// Left out  identical pairs as a control: a guesser is known by being right in a third.
// Exact     same design and answers, same trial, on any processor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/told_apart/told_apart.h"

namespace tact {

struct TrialPair {
    std::string a;
    std::string b;
    double pm = 0.0;

    bool operator==(const TrialPair&) const = default;
};

struct TrialDesign {
    int trials = 20;  // kFewestOddTrials to kMostOddTrials
    std::uint64_t seed = 1;
    std::vector<TrialPair> pairs;

    bool operator==(const TrialDesign&) const = default;
};

// None once all are answered, or without a pair of a PM above 0.
std::optional<OddOneOut> next_trial(const TrialDesign& design, std::span<const OddAnswer> answers);

// The closest pair of PM above 0, the farthest, and those between that are nearest to even steps of
// ln PM: `most` pairs, or all if there are fewer. In the order of their PM.
inline constexpr std::size_t kUsualTrialPairs = 12;
std::vector<TrialPair> pairs_to_ask(const std::vector<std::string>& names, const Dissimilarity& pm,
                                    std::size_t most = kUsualTrialPairs);

// A simulated person in odd-one-out trials, for tests and for looking at the program without a
// phone.
//
// Source    threshold_posterior.h, whose share of right answers it has; who errs takes either of
//           the other two places
// Exact     same person and trial, same answer, on any processor

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
