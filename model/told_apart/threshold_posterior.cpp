#include "model/told_apart/threshold_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "model/common/portable.h"
#include "model/told_apart/told_apart.h"

namespace tact {

namespace {

constexpr std::size_t kThresholds = 61;
constexpr double kBeyondAsked = 8.0;  // the prior reaches that factor beyond

constexpr double kRise = 1.0 - kOddGuess - kOddLapse;
// The odds of (1 - F) to F at the threshold.
constexpr double kMissOdds = kRise / (kToldApartShare - kOddGuess) - 1.0;

// `odds`: (threshold / PM)^slope.
double share_at(double odds) { return kOddGuess + kRise / (1.0 + kMissOdds * odds); }

// The share of each threshold and slope, in the order of the weights.
std::vector<double> shares_at(const ThresholdPosterior& posterior, double pm) {
    std::vector<double> shares;
    shares.reserve(posterior.weight.size());
    const double log_pm = portable::log(pm);
    for (const double log_threshold : posterior.log_pm) {
        double odds = portable::exp(log_threshold - log_pm);
        for (std::size_t s = 0; s < kThresholdSlopes.size(); ++s, odds *= odds) {
            shares.push_back(share_at(odds));
        }
    }
    return shares;
}

// In nats, of an answer that is right with a probability between 0 and 1.
double entropy(double right) {
    return -right * portable::log(right) - (1.0 - right) * portable::log(1.0 - right);
}

}  // namespace

double share_right(double pm, double threshold_pm, double slope) {
    if (!(pm > 0.0) || std::isinf(threshold_pm)) return kOddGuess;
    return share_at(portable::pow(threshold_pm / pm, slope));
}

Range range_of_pm(std::span<const double> pm) {
    Range range{std::numeric_limits<double>::infinity(), 0.0};
    for (const double one : pm) {
        if (!can_be_asked(one)) continue;
        range.low = std::min(range.low, one);
        range.high = std::max(range.high, one);
    }
    return range.high > 0.0 ? range : Range{1.0, 1.0};
}

ThresholdPosterior threshold_posterior(Range pm, std::span<const AskedPm> answers) {
    const double low = portable::log(pm.low / kBeyondAsked);
    const double high = portable::log(pm.high * kBeyondAsked);
    ThresholdPosterior posterior{{}, (high - low) / (kThresholds - 1)};
    for (std::size_t k = 0; k < kThresholds; ++k) {
        posterior.log_pm.push_back(low + posterior.step * static_cast<double>(k));
    }
    posterior.weight.assign(kThresholds * kThresholdSlopes.size(), 1.0);
    std::map<double, std::vector<double>> shares_of;  // by PM, each once
    for (const AskedPm& answer : answers) {
        if (!can_be_asked(answer.pm)) continue;
        std::vector<double>& shares = shares_of[answer.pm];
        if (shares.empty()) shares = shares_at(posterior, answer.pm);
        double sum = 0.0;
        for (std::size_t k = 0; k < shares.size(); ++k) {
            sum += posterior.weight[k] *= answer.is_right ? shares[k] : 1.0 - shares[k];
        }
        for (double& weight : posterior.weight) weight /= sum;  // however many there are
    }
    const double sum = std::accumulate(posterior.weight.begin(), posterior.weight.end(), 0.0);
    for (double& weight : posterior.weight) weight /= sum;
    return posterior;
}

double threshold_below(const ThresholdPosterior& posterior, double probability) {
    // The density of a threshold is even from half a step below to half a step above it.
    double below = 0.0;
    double log_pm = posterior.log_pm.back();
    for (std::size_t k = 0; k < posterior.log_pm.size(); ++k) {
        double own = 0.0;
        for (std::size_t s = 0; s < kThresholdSlopes.size(); ++s) {
            own += posterior.weight[k * kThresholdSlopes.size() + s];
        }
        if (below + own >= probability && own > 0.0) {
            log_pm = posterior.log_pm[k] + posterior.step * ((probability - below) / own - 0.5);
            break;
        }
        below += own;
    }
    return portable::exp(std::clamp(log_pm, posterior.log_pm.front(), posterior.log_pm.back()));
}

PredictedShare predicted_share(const ThresholdPosterior& posterior, double pm) {
    PredictedShare predicted{kOddGuess, {kOddGuess, kOddGuess}};
    if (!can_be_asked(pm)) return predicted;
    const std::vector<double> shares = shares_at(posterior, pm);
    std::vector<std::pair<double, double>> share_and_weight;
    predicted.share = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        predicted.share += posterior.weight[k] * shares[k];
        share_and_weight.emplace_back(shares[k], posterior.weight[k]);
    }
    std::ranges::sort(share_and_weight);
    const auto below = [&share_and_weight](double probability) {
        double sum = 0.0;
        for (const auto& [share, weight] : share_and_weight) {
            sum += weight;
            if (sum >= probability) return share;
        }
        return share_and_weight.back().first;
    };
    predicted.interval = {below(0.025), below(0.975)};
    return predicted;
}

double expected_information(const ThresholdPosterior& posterior, double pm) {
    if (!can_be_asked(pm)) return 0.0;
    const std::vector<double> shares = shares_at(posterior, pm);
    double right = 0.0;
    double known = 0.0;  // entropy of the answer that is left where the threshold is known
    for (std::size_t k = 0; k < posterior.log_pm.size(); ++k) {
        double own = 0.0;
        double own_right = 0.0;
        for (std::size_t s = 0; s < kThresholdSlopes.size(); ++s) {
            const std::size_t cell = k * kThresholdSlopes.size() + s;
            own += posterior.weight[cell];
            own_right += posterior.weight[cell] * shares[cell];
        }
        right += own_right;
        if (own > 0.0) known += own * entropy(own_right / own);
    }
    return std::max(0.0, entropy(right) - known);
}

}  // namespace tact
