#include "model/study/synthetic_study.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/common/random.h"
#include "model/study/adaptive_order.h"

namespace tact {

namespace {

double linkage(const Dissimilarity& d, const std::vector<std::size_t>& a,
               const std::vector<std::size_t>& b) {
    double sum = 0.0;
    for (const std::size_t i : a) {
        for (const std::size_t j : b) sum += d(i, j);
    }
    return sum / static_cast<double>(a.size() * b.size());
}

struct Join {
    std::size_t a = 0;
    std::size_t b = 0;
    double height = 0.0;
};

Join nearest(const Dissimilarity& d, const std::vector<std::vector<std::size_t>>& groups) {
    std::optional<Join> best;
    for (std::size_t a = 0; a < groups.size(); ++a) {
        for (std::size_t b = a + 1; b < groups.size(); ++b) {
            const double height = linkage(d, groups[a], groups[b]);
            if (!best || height < best->height) best = Join{a, b, height};
        }
    }
    return best.value_or(Join{});
}

// What the rater feels between all patterns before they sort.
Dissimilarity felt_by(const SyntheticRater& rater, std::uint64_t round) {
    const std::size_t n = rater.truth.size;
    Dissimilarity felt{n, {}};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const std::uint64_t serial = round * pair_count(n) + pair_index(n, i, j);
            felt.condensed.push_back(100.0 - rating_of(rater, {i, j}, serial));
        }
    }
    return felt;
}

void answer_pairs(StudyRecord& record, const SyntheticRater& rater) {
    const StudyHeader& header = record.header;
    const TrialPlan plan = plan_of(header.design, header.patterns.size(), header.seed);
    const bool is_full = header.design.order == StudyOrder::full;
    const std::vector<Trial> trials = is_full ? trial_list(plan) : std::vector<Trial>{};
    std::vector<RatedTrial> rated;
    for (std::uint64_t serial = 0;; ++serial) {
        std::optional<Trial> trial;
        if (!is_full) trial = next_adaptive_trial(plan, rated);
        if (serial < trials.size()) trial = trials[serial];
        if (!trial) return;
        const double similarity = rating_of(rater, *trial, serial);
        rated.push_back({*trial, similarity});
        record.answers.push_back(
            {*trial, similarity, 1, 1, response_s_of(rater, serial), std::string()});
    }
}

void answer_rounds(StudyRecord& record, const SyntheticRater& rater) {
    while (answers_given(record) < answers_wanted(record)) {
        const std::size_t round = record.sortings.size();
        std::vector<int> rounds = record.header.design.groups;
        if (rounds.empty()) {
            const std::size_t free_choice =
                round == 0 ? 0 : group_count(record.sortings.front().groups);
            rounds = sorting_rounds(record.header.patterns.size(), free_choice);
        }
        const int asked = rounds[round];
        record.sortings.push_back(
            {asked, average_linkage(felt_by(rater, round), static_cast<std::size_t>(asked)),
             5.0 * response_s_of(rater, round), std::string()});
    }
}

}  // namespace

Sorting average_linkage(const Dissimilarity& dissimilarity, std::size_t wanted) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < dissimilarity.size; ++k) groups.push_back({k});
    double low = 0.0;
    double high = 0.0;
    if (!dissimilarity.condensed.empty()) {
        const auto range = std::ranges::minmax(dissimilarity.condensed);
        low = range.min;
        high = range.max;
    }
    const double widest = low + 0.2 * (high - low);
    while (groups.size() > std::max<std::size_t>(wanted, 1)) {
        const Join join = nearest(dissimilarity, groups);
        if (wanted == 0 && join.height > widest) break;
        groups[join.a].insert(groups[join.a].end(), groups[join.b].begin(), groups[join.b].end());
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(join.b));
    }
    Sorting sorting(dissimilarity.size, 0);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (const std::size_t pattern : groups[g]) sorting[pattern] = g;
    }
    return sorting;
}

StudyRecord simulated_study(StudyHeader header, const SyntheticRater& rater) {
    header.synthetic = true;
    StudyRecord record{std::move(header), {}, {}, false};
    if (record.header.kind == StudyKind::pairwise) {
        answer_pairs(record, rater);
    } else {
        answer_rounds(record, rater);
    }
    return record;
}

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
