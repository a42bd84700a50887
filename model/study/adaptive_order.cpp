#include "model/study/adaptive_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/common/random.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/study/ratings.h"

namespace tact {

namespace {

using Values = std::vector<double>;

constexpr int kDimensions = 2;
constexpr std::size_t kCommittee = 6;
constexpr std::uint64_t kCircleStream = 100;  // beyond those of the full design

// What is known of the pairs: how often each was asked, and the mean of its answers.
struct Known {
    std::vector<std::size_t> count;
    Dissimilarity mean;  // NaN: not asked yet
    std::optional<std::size_t> last;
};

Known known_from(std::size_t n, std::span<const RatedTrial> answers) {
    Known known{std::vector<std::size_t>(pair_count(n)), {n, Values(pair_count(n), 0.0)}, {}};
    for (const RatedTrial& answer : answers) {
        if (answer.trial.is_attention()) continue;
        const auto [low, high] = std::minmax(answer.trial.left, answer.trial.right);
        const std::size_t pair = pair_index(n, low, high);
        ++known.count[pair];
        known.mean.condensed[pair] += 100.0 - answer.similarity;
        known.last = pair;
    }
    for (std::size_t pair = 0; pair < known.count.size(); ++pair) {
        known.mean.condensed[pair] =
            known.count[pair] > 0
                ? known.mean.condensed[pair] / static_cast<double>(known.count[pair])
                : std::numeric_limits<double>::quiet_NaN();
    }
    return known;
}

MdsParams quick_params() {
    MdsParams params;
    params.dimensions = kDimensions;
    params.random_starts = static_cast<int>(kCommittee);
    params.tolerance = 1e-5;
    params.max_steps = 300;
    params.threads = 1;
    return params;
}

// Patterns around a table: neighbours first, then those opposite, then a third of the way. Every
// pattern is in as many pairs, and all hang together from the first round.
std::vector<std::size_t> opening_pairs(const TrialPlan& plan) {
    const std::size_t n = plan.patterns;
    RandomStream random{random_bits(plan.seed, kCircleStream)};
    std::vector<std::size_t> seat(n);
    next_permutation_of(random, seat);
    std::vector<std::size_t> pairs;
    for (const std::size_t ahead : {std::size_t{1}, n / 2, n / 3}) {
        for (std::size_t k = 0; k < n; ++k) {
            const auto [low, high] = std::minmax(seat[k], seat[(k + ahead) % n]);
            if (low == high) continue;
            const std::size_t pair = pair_index(n, low, high);
            if (std::ranges::find(pairs, pair) == pairs.end()) pairs.push_back(pair);
        }
    }
    return pairs;
}

// How far apart maps from several starts place each pair, as a variance: what the answers have not
// said yet. A map that fits worse has less of a say.
Values disagreement_of_maps(const Dissimilarity& ratings) {
    const auto n = static_cast<Eigen::Index>(ratings.size);
    const MdsParams params = quick_params();
    const std::size_t pairs = ratings.condensed.size();
    Values sum(pairs, 0.0);
    Values squares(pairs, 0.0);
    double weights = 0.0;
    for (std::size_t k = 0; k < kCommittee; ++k) {
        const PerceptualSpace map =
            smacof(ratings, random_start(n, kDimensions, params.seed, k + 1), params);
        const double weight = 1.0 / (0.02 + map.stress1);
        const Values apart = distances(map.points);
        weights += weight;
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            sum[pair] += weight * apart[pair];
            squares[pair] += weight * apart[pair] * apart[pair];
        }
    }
    Values spread(pairs);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const double mean = sum[pair] / weights;
        spread[pair] = squares[pair] / weights - mean * mean;
    }
    return spread;
}

// How far each rating's rank is from that of its distance in the best map.
Values misfit(const Dissimilarity& ratings) {
    const PerceptualSpace map = nonmetric_mds(ratings, quick_params());
    if (map.points.rows() != static_cast<Eigen::Index>(ratings.size)) {
        return Values(ratings.condensed.size(), 0.0);
    }
    const Values said = average_ranks(ratings.condensed);
    const Values placed = average_ranks(distances(map.points));
    Values far(said.size());
    for (std::size_t pair = 0; pair < said.size(); ++pair) {
        far[pair] = std::abs(said[pair] - placed[pair]);
    }
    return far;
}

std::size_t most_telling(const Known& known, std::size_t pass) {
    const Values score = pass == 0 ? disagreement_of_maps(known.mean) : misfit(known.mean);
    std::optional<std::size_t> best;
    for (std::size_t pair = 0; pair < score.size(); ++pair) {
        if (known.count[pair] != pass || known.last == pair) continue;
        if (!best || score[pair] > score[*best]) best = pair;
    }
    // With two patterns the only pair follows itself.
    return best.value_or(known.last.value_or(0));
}

std::size_t next_pair(const TrialPlan& plan, const Known& known, std::size_t pass) {
    if (pass == 0) {
        for (const std::size_t pair : opening_pairs(plan)) {
            if (known.count[pair] == 0) return pair;
        }
    }
    return most_telling(known, pass);
}

}  // namespace

std::optional<Trial> next_adaptive_trial(const TrialPlan& plan,
                                         std::span<const RatedTrial> answers) {
    const std::size_t pairs = pair_count(plan.patterns);
    std::size_t rated = 0;
    for (const RatedTrial& answer : answers) rated += answer.trial.is_attention() ? 0 : 1;
    if (pairs == 0 || rated >= pairs * static_cast<std::size_t>(plan.repetitions)) return {};
    const std::size_t tested = answers.size() - rated;
    const std::vector<AttentionPlace> places = attention_places(plan);
    if (tested < places.size() && places[tested].before <= rated) {
        return Trial{places[tested].pattern, places[tested].pattern};
    }
    const std::size_t pass = rated / pairs;
    const Known known = known_from(plan.patterns, answers);
    return sided_trial(plan, next_pair(plan, known, pass), pass);
}

MapSettling map_settling(std::size_t patterns, std::span<const RatedTrial> answers) {
    constexpr std::size_t kChanges = 3;
    MapSettling settling;
    if (patterns < 4) return settling;
    std::optional<Eigen::MatrixXd> later;
    for (std::size_t k = 0; k <= kChanges; ++k) {
        // Two pairs a pattern make the map hang together.
        if (answers.size() < (k + 2) * patterns) break;
        const Known known = known_from(patterns, answers.first(answers.size() - k * patterns));
        const PerceptualSpace map = nonmetric_mds(known.mean, quick_params());
        if (later) {
            const Expected<double> change = alienation(*later, map.points);
            if (!change) break;
            settling.change.push_back(*change);
        }
        later = map.points;
    }
    settling.is_settled =
        settling.change.size() == kChanges &&
        std::ranges::all_of(settling.change, [](double k) { return k <= kSettledChange; });
    return settling;
}

}  // namespace tact
