// From which PM on a person tells patterns apart: what answers say of it, by Bayes' rule on a grid.
//
// Source    the share that is right, p = 1/3 + (1 - 1/3 - lapse) F (Green & Swets 1966), with
//           lapses as Wichmann & Hill 2001 show that they have to be allowed for: 0.02, fixed, so
//           that one slip moves little. F is the logistic function of ln PM; the threshold is the
//           PM at which p = 3/4. Posterior of threshold and slope: Kontsevich & Tyler 1999.
// Input     PM above 0; others are passed over
// Output    a prior that is even in the logarithms of threshold (an eighth of the smallest to eight
//           times the largest PM) and slope (1 to 16: p rises from a tenth to nine tenths of its
//           way while PM grows 80-fold to 1.3-fold), times the likelihood of the answers
// Valid     scale-free: PM times a factor is a threshold times that factor
// Left out  learning, fatigue, bias for a place, lapses of another share; that PM puts pairs in the
//           wrong order, of which the slope is the wider.
// Exact     same input, same bits, on any processor.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/common/distributions.h"
#include "model/common/units.h"

namespace tact {

inline constexpr double kOddGuess = 1.0 / 3.0;
inline constexpr double kOddLapse = 0.02;
inline constexpr double kToldApartShare = 0.75;  // at the threshold

// From 1 on, each twice the one before.
inline constexpr std::array kThresholdSlopes{1.0, 2.0, 4.0, 8.0, 16.0};

// The share of trials that is right at a PM; guesses of whoever has an infinite threshold.
double share_right(double pm, double threshold_pm, double slope);

struct AskedPm {
    double pm = 0.0;
    bool is_right = false;
};

// The smallest and the largest of the PM above 0; {1, 1} of none.
Range range_of_pm(std::span<const double> pm);

struct ThresholdPosterior {
    std::vector<double> log_pm;    // thresholds, evenly spaced
    double step = 0.0;             // between them
    std::vector<double> weight{};  // of threshold times slope, slopes inner; their sum is 1
};

// Without answers it is the prior.
ThresholdPosterior threshold_posterior(Range pm, std::span<const AskedPm> answers);

// The threshold, in PM, below which it lies with a probability.
double threshold_below(const ThresholdPosterior& posterior, double probability);

// The share of trials that would be right at a PM: the mean, and the middle 95 %.
struct PredictedShare {
    double share = 0.0;
    Interval interval{};
};
PredictedShare predicted_share(const ThresholdPosterior& posterior, double pm);

// What an answer at this PM is expected to say of the threshold, in nats; of the slope only as far
// as that tells of the threshold (Prins 2013, psi-marginal).
double expected_information(const ThresholdPosterior& posterior, double pm);

}  // namespace tact
