#include "model/told_apart/told_apart_results.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "model/common/distributions.h"

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

}  // namespace tact
