#include "model/study/synthetic_rater.h"

#include <algorithm>
#include <cmath>

#include "model/common/random.h"

namespace tact {

namespace {

std::uint64_t own_stream(const SyntheticRater& rater, std::uint64_t which) {
    return random_bits(random_bits(rater.params.seed, rater.number), which);
}

// The pair's dissimilarity as a share of the largest; of none that is known 0.
double share_of_largest(const Dissimilarity& truth, const Trial& trial) {
    double largest = 0.0;
    double sum = 0.0;
    std::size_t known = 0;
    for (const double value : truth.condensed) {
        if (!std::isfinite(value)) continue;
        largest = std::max(largest, value);
        sum += value;
        ++known;
    }
    if (largest <= 0.0) return 0.0;
    const double own = truth(trial.left, trial.right);
    return (std::isfinite(own) ? own : sum / static_cast<double>(known)) / largest;
}

}  // namespace

double rating_of(const SyntheticRater& rater, const Trial& trial, std::uint64_t serial) {
    const SyntheticRaterParams& params = rater.params;
    RandomStream person{own_stream(rater, 0)};
    const double bias = params.bias + params.bias_spread * next_normal(person);
    RandomStream answer{random_bits(own_stream(rater, 1), serial)};
    const bool is_lapse = 0.5 * (next_even(answer) + 1.0) < params.lapses;
    if (is_lapse) return static_cast<double>(next_index(answer, 101));
    double similarity = 100.0 * (1.0 - share_of_largest(rater.truth, trial));
    // What is felt to be the same stays so: there bias and most of the noise have no room.
    similarity += trial.is_attention() ? -0.3 * params.noise * std::abs(next_normal(answer))
                                       : bias + params.noise * next_normal(answer);
    return std::clamp(std::round(similarity), 0.0, 100.0);
}

double response_s_of(const SyntheticRater& rater, std::uint64_t serial) {
    RandomStream random{random_bits(own_stream(rater, 2), serial)};
    const double more_s = 8.0 * std::abs(next_normal(random));
    return 3.0 + std::round(10.0 * more_s) / 10.0;
}

}  // namespace tact
