#include "model/told_apart/told_apart_words.h"

#include <cmath>

#include "model/text/numbers.h"

namespace tact {

namespace {

std::string trials_words(std::size_t trials) { return counted(trials, "trial", "trials"); }

// What was answered, if it was all the same or no better than guesses; empty otherwise.
std::string answered_words(const ToldApartResults& results) {
    const std::string trials = trials_words(results.trials);
    if (results.right == results.trials) return "All " + trials + " were right. ";
    if (results.right == 0) return "None of " + trials + " was right. ";
    if (!results.may_be_guesses()) return {};
    return grouped_digits(results.right) + " of " + trials +
           " right: guesses may be right as often. ";
}

// The threshold as the beginning of a sentence.
std::string threshold_is() {
    return "The PM from which pairs are told apart in " + percent(kToldApartShare) +
           " of trials is ";
}

std::string lowest(const ToldApartResults& results) {
    return results.threshold.low < results.asked_pm.low ? "below " + pm_digits(results.asked_pm.low)
                                                        : pm_digits(results.threshold.low);
}

std::string highest(const ToldApartResults& results) {
    return results.threshold.high > results.asked_pm.high
               ? "above " + pm_digits(results.asked_pm.high)
               : pm_digits(results.threshold.high);
}

std::string found_words(const ToldApartResults& results) {
    return "Pairs beyond PM " + pm_digits(results.threshold_pm) + " (" + lowest(results) + " to " +
           highest(results) + ") were told apart in at least " + percent(kToldApartShare) +
           " of trials.";
}

std::string unclear_words(const ToldApartResults& results) {
    const std::string least = pm_digits(results.asked_pm.low);
    const bool is_one = results.asked_pm.low == results.asked_pm.high;
    return answered_words(results) +
           "These trials do not say from which PM pairs are told apart: it may be below " + least +
           (is_one ? " or above it, the only one that was asked."
                   : ", the smallest that was asked, or above " + pm_digits(results.asked_pm.high) +
                         ", the largest.");
}

std::string below_words(const ToldApartResults& results) {
    const std::string said = answered_words(results) + threshold_is();
    const std::string below =
        "below " + pm_digits(results.asked_pm.low) + ", the smallest that was asked";
    if (results.threshold.high <= results.asked_pm.low) return said + below + ".";
    return said + "most likely " + below + ", and below " + pm_digits(results.threshold.high) +
           " with 95 % certainty.";
}

std::string above_words(const ToldApartResults& results) {
    const std::string said = answered_words(results) + threshold_is();
    const std::string above =
        "above " + pm_digits(results.asked_pm.high) + ", the largest that was asked";
    if (results.threshold.low >= results.asked_pm.high) return said + above + ".";
    return said + "most likely " + above + ", and above " + pm_digits(results.threshold.low) +
           " with 95 % certainty.";
}

}  // namespace

std::string pm_digits(double pm) {
    constexpr double kManyDigits = 1e15;  // beyond which a count of units says nothing
    if (!(pm >= 9.95) || pm > kManyDigits) return significant_digits(pm, 2);
    return grouped_digits(static_cast<std::size_t>(std::llround(pm)));
}

std::string share_words(const ToldApartResults& results) {
    if (results.trials == 0) return "No trial was answered.";
    const double share = static_cast<double>(results.right) / static_cast<double>(results.trials);
    return grouped_digits(results.right) + " of " + trials_words(results.trials) +
           (results.right == 1 ? " was right: " : " were right: ") + percent(share) + " (" +
           percent_range(results.interval.low, results.interval.high) +
           "). A guess is right in a third of trials.";
}

std::string threshold_words(const ToldApartResults& results) {
    switch (results.said) {
        case ThresholdSaid::too_few:
            return "Too few trials to say from which PM pairs are told apart: " +
                   grouped_digits(results.trials) + " of at least " +
                   std::to_string(limits::kFewestOddTrials) + ".";
        case ThresholdSaid::unclear:
            return unclear_words(results);
        case ThresholdSaid::below:
            return below_words(results);
        case ThresholdSaid::above:
            return above_words(results);
        case ThresholdSaid::found:
            break;
    }
    return found_words(results);
}

std::string words_at(const ToldApartResults& results, double pm) {
    const std::string share = percent(predicted_share(results.posterior, pm).share) + " of trials";
    const std::string pairs = "pairs at PM " + pm_digits(pm);
    if (pm < results.asked_pm.low) {
        return pairs + ", less than any that was asked, may be told apart in about " + share;
    }
    if (pm > results.asked_pm.high) {
        return pairs + ", more than any that was asked, may be told apart in about " + share;
    }
    return pairs + " were told apart in about " + share;
}

std::string asked_words(const ToldApart& told, const ToldApartResults& results) {
    return (told.synthetic ? "simulated, " : "one person, ") + trials_words(results.trials);
}

}  // namespace tact
