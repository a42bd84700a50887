#include "model/study/synthetic_study.h"

#include <algorithm>
#include <optional>
#include <utility>

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

}  // namespace tact
