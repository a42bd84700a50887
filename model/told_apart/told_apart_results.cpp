#include "model/told_apart/told_apart_results.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/common/distributions.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kMiddle = 0.95;

void count(std::vector<ToldApartPair>& pairs, const OddAnswer& answer) {
    auto pair = std::ranges::find_if(
        pairs, [&answer](const ToldApartPair& one) { return one.is_same(answer.trial); });
    if (pair == pairs.end()) {
        const OddOneOut& trial = answer.trial;
        pair = pairs.insert(pairs.end(), {trial.a, trial.b, trial.pm});
    }
    ++pair->trials;
    if (answer.is_right()) ++pair->right;
}

ThresholdSaid said_of(const ToldApartResults& results) {
    if (results.trials < limits::kFewestOddTrials) return ThresholdSaid::too_few;
    const bool may_be_below = results.threshold.low < results.asked_pm.low;
    const bool may_be_above = results.threshold.high > results.asked_pm.high;
    if (may_be_below && may_be_above) return ThresholdSaid::unclear;
    if (results.threshold_pm < results.asked_pm.low) return ThresholdSaid::below;
    if (results.threshold_pm > results.asked_pm.high) return ThresholdSaid::above;
    return ThresholdSaid::found;
}

}  // namespace

Interval wilson_interval(std::size_t right, std::size_t all) {
    if (all == 0) return {0.0, 1.0};
    static const double kZ = two_sided_quantile(kMiddle, 0);
    const double n = static_cast<double>(all);
    const double share = static_cast<double>(right) / n;
    const double middle = share + kZ * kZ / (2.0 * n);
    const double half = kZ * std::sqrt(share * (1.0 - share) / n + kZ * kZ / (4.0 * n * n));
    const double scale = 1.0 + kZ * kZ / n;
    return {right == 0 ? 0.0 : (middle - half) / scale,
            right == all ? 1.0 : (middle + half) / scale};
}

ToldApartResults results_of(const ToldApart& told) {
    ToldApartResults results;
    std::vector<double> pm;
    std::vector<AskedPm> asked;
    for (const OddAnswer& answer : told.answers) {
        if (!can_be_asked(answer.trial.pm)) continue;
        ++results.trials;
        if (answer.is_right()) ++results.right;
        pm.push_back(answer.trial.pm);
        asked.push_back({answer.trial.pm, answer.is_right()});
        count(results.pairs, answer);
    }
    results.interval = wilson_interval(results.right, results.trials);
    results.asked_pm = range_of_pm(pm);
    results.posterior = threshold_posterior(results.asked_pm, asked);
    results.threshold_pm = threshold_below(results.posterior, 0.5);
    results.threshold = {threshold_below(results.posterior, 0.5 - kMiddle / 2.0),
                         threshold_below(results.posterior, 0.5 + kMiddle / 2.0)};
    results.said = said_of(results);
    for (ToldApartPair& pair : results.pairs) {
        pair.interval = wilson_interval(pair.right, pair.trials);
        pair.predicted = predicted_share(results.posterior, pair.pm);
    }
    std::ranges::stable_sort(results.pairs, [](const auto& one, const auto& other) {
        return std::tie(one.pm, one.a, one.b) < std::tie(other.pm, other.a, other.b);
    });
    return results;
}

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
