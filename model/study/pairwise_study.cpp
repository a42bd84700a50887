#include "model/study/pairwise_study.h"

#include <algorithm>
#include <span>
#include <utility>

#include "model/common/fingerprint.h"
#include "model/common/random.h"
#include "model/dissimilarity/dissimilarity.h"

namespace tact {

namespace {

// Streams of a plan's seed, one for each thing that is drawn.
enum class Draw : std::uint64_t { training, passes, labels, sides, attention };

RandomStream stream_of(const TrialPlan& plan, Draw draw) {
    return {random_bits(plan.seed, static_cast<std::uint64_t>(draw))};
}

std::vector<std::size_t> shuffled(RandomStream& random, std::size_t count) {
    std::vector<std::size_t> order(count);
    next_permutation_of(random, order);
    return order;
}

// A regular tournament: of players around a table each beats the next half. So every pattern is on
// the left of half of its pairs, within one.
bool beats(std::size_t players, std::size_t i, std::size_t j) {
    const std::size_t ahead = (j + players - i) % players;
    if (2 * ahead == players) return i < j;
    return 2 * ahead < players;
}

std::size_t rated_trials(const TrialPlan& plan) {
    return pair_count(plan.patterns) * static_cast<std::size_t>(plan.repetitions);
}

}  // namespace

TrialPlan plan_of(const StudyDesign& design, std::size_t patterns, std::uint64_t seed) {
    return {patterns, design.repetitions, design.attention_pairs, seed};
}

std::uint64_t participant_seed(int study_seed, const std::string& participant) {
    return mixed(static_cast<std::uint64_t>(study_seed), std::span<const char>(participant));
}

std::vector<std::size_t> training_order(const TrialPlan& plan) {
    RandomStream random = stream_of(plan, Draw::training);
    return shuffled(random, plan.patterns);
}

Trial sided_trial(const TrialPlan& plan, std::size_t pair, std::size_t pass) {
    const auto [i, j] = pair_at(plan.patterns, pair);
    RandomStream labels = stream_of(plan, Draw::labels);
    const std::vector<std::size_t> seat = shuffled(labels, plan.patterns);
    const bool is_first_left = beats(plan.patterns, seat[i], seat[j]);
    // Every second pass the other way round, in an order of the pair's own.
    RandomStream sides{random_bits(stream_of(plan, Draw::sides).stream, pair)};
    const std::vector<std::size_t> turn =
        shuffled(sides, static_cast<std::size_t>(plan.repetitions));
    const bool is_turned = turn[pass] % 2 == 1;
    return is_first_left != is_turned ? Trial{i, j} : Trial{j, i};
}

std::vector<AttentionPlace> attention_places(const TrialPlan& plan) {
    const std::size_t trials = rated_trials(plan);
    const std::size_t count = std::min(static_cast<std::size_t>(plan.attention_pairs), trials);
    std::vector<AttentionPlace> places;
    RandomStream random = stream_of(plan, Draw::attention);
    const std::vector<std::size_t> order = shuffled(random, plan.patterns);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t begin = k * trials / count;
        const std::size_t end = (k + 1) * trials / count;
        places.push_back({begin + next_index(random, end - begin), order[k % order.size()]});
    }
    return places;
}

std::vector<Trial> trial_list(const TrialPlan& plan) {
    std::vector<Trial> trials;
    if (plan.patterns < 2) return trials;
    const std::vector<AttentionPlace> attention = attention_places(plan);
    RandomStream random = stream_of(plan, Draw::passes);
    std::size_t last = pair_count(plan.patterns);  // none
    std::size_t rated = 0;
    auto next_attention = attention.begin();
    for (std::size_t pass = 0; pass < static_cast<std::size_t>(plan.repetitions); ++pass) {
        std::vector<std::size_t> order = shuffled(random, pair_count(plan.patterns));
        if (order.front() == last && order.size() > 1) {
            std::swap(order.front(), order[1 + next_index(random, order.size() - 1)]);
        }
        for (const std::size_t pair : order) {
            if (next_attention != attention.end() && next_attention->before == rated) {
                trials.push_back({next_attention->pattern, next_attention->pattern});
                ++next_attention;
            }
            trials.push_back(sided_trial(plan, pair, pass));
            ++rated;
        }
        last = order.back();
    }
    return trials;
}

}  // namespace tact
