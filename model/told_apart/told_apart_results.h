// What the trials of one person on one device say: the share that was right, and from which PM on
// pairs were told apart.
//
// Source    the share's interval: Wilson 1927, which Brown, Cai & DasGupta 2001 recommend for few
//           trials; the threshold: threshold_posterior.h, its median and middle 95 %
// Input     answers of pairs of PM above 0
// Output    what may be said of the threshold, by the PM that were asked: beyond them it is only
//           said on which side it lies
// Valid     for this person, on this device: others have another skin and another actuator
// Exact     same answers, same bits, on any processor.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/common/distributions.h"
#include "model/told_apart/threshold_posterior.h"
#include "model/told_apart/told_apart.h"

namespace tact {

// The middle 95 % of a share of which `right` of `all` were counted; 0 to 1 of none.
Interval wilson_interval(std::size_t right, std::size_t all);

enum class ThresholdSaid {
    too_few,  // fewer than kFewestOddTrials answers
    unclear,  // it may lie anywhere, from below all PM that were asked to above them
    below,    // all PM that were asked
    above,    // all of them
    found
};

struct ToldApartPair {
    std::string a;
    std::string b;
    double pm = 0.0;
    std::size_t trials = 0;
    std::size_t right = 0;
    Interval interval{};         // of the share that was right
    PredictedShare predicted{};  // by all trials

    bool is_same(const OddOneOut& trial) const {
        return a == trial.a && b == trial.b && pm == trial.pm;
    }
};

struct ToldApartResults {
    std::size_t trials = 0;
    std::size_t right = 0;
    Interval interval{0.0, 1.0};  // of the share
    Range asked_pm{0.0, 0.0};     // the smallest and the largest
    ThresholdSaid said = ThresholdSaid::too_few;
    double threshold_pm = 0.0;  // told apart in three quarters of trials
    Interval threshold{};
    std::vector<ToldApartPair> pairs;  // by rising PM
    ThresholdPosterior posterior{};

    // Whether guesses alone may be right as often.
    bool may_be_guesses() const { return interval.low <= kOddGuess; }
};

ToldApartResults results_of(const ToldApart& told);

// The results of trials in plain English.
//
// Output    whole sentences; of what the data do not say they tell that it is not known. PM of 10
//           and more in whole numbers, below with two digits; shares in whole percent
// Valid     95 % intervals throughout, of one person on one device

// "12", "1,200", "0.45".
std::string pm_digits(double pm);

// "15 of 20 trials were right: 75 % (53 to 89 %). A guess is right in a third of trials."
std::string share_words(const ToldApartResults& results);

// "Pairs beyond PM 12 (8 to 19) were told apart in at least 75 % of trials.", or what can be said
// in its place: the threshold is below or above all that was asked, or not known.
std::string threshold_words(const ToldApartResults& results);

// "pairs at PM 9 were told apart in about 62 % of trials"; of a PM that was not among those asked:
// "pairs at PM 2, less than any that was asked, may be told apart in about 40 % of trials".
std::string words_at(const ToldApartResults& results, double pm);

// "one person, 20 trials"; of nobody "simulated, 20 trials".
std::string asked_words(const ToldApart& told, const ToldApartResults& results);

}  // namespace tact
