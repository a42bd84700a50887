#include "model/study/conduct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/common/distributions.h"
#include "model/dissimilarity/correlation.h"
#include "model/study/study_results.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::vector<double> response_times_s(const StudyRecord& record) {
    std::vector<double> times;
    for (std::size_t k = 0; k < answers_given(record); ++k) {
        if (felt_of(record, k) != Felt::whole) continue;
        times.push_back(record.header.kind == StudyKind::pairwise ? record.answers[k].response_s
                                                                  : record.sortings[k].response_s);
    }
    return times;
}

double mean_replays(const StudyRecord& record) {
    std::vector<double> replays;
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        if (felt_of(record, k) == Felt::whole) {
            replays.push_back(static_cast<double>(replays_of(record.answers[k])));
        }
    }
    return mean_known(replays);
}

std::string fault_of_speed(const StudyRecord& record, const ConductRule& rule) {
    const std::vector<double> times = response_times_s(record);
    const auto fast = static_cast<std::size_t>(std::ranges::count_if(
        times, [&rule](double time_s) { return time_s < *rule.fast_below_s; }));
    if (is_at_most_share(fast, rule.fast_share, times.size())) return {};
    return grouped_digits(fast) + " of " + grouped_digits(times.size()) + " answers in under " +
           shortest_digits(*rule.fast_below_s) + " s, expected at most " +
           exact_percent(rule.fast_share);
}

}  // namespace

bool is_on(const ConductRule& rule, ConductTest test) {
    switch (test) {
        case ConductTest::speed:
            return rule.fast_below_s.has_value();
        case ConductTest::repetition:
            return rule.repeat_rho.has_value();
        case ConductTest::replays:
            return rule.replays.has_value();
    }
    return false;
}

bool is_any_on(const ConductRule& rule) {
    return std::ranges::any_of(kConductTests,
                               [&rule](ConductTest test) { return is_on(rule, test); });
}

std::string words_on(const ConductRule& rule, ConductTest test) {
    if (!is_on(rule, test)) return {};
    switch (test) {
        case ConductTest::speed:
            return "at most " + significant_digits(100.0 * rule.fast_share, 3) +
                   " % of the answers in under " + shortest_digits(*rule.fast_below_s) + " s";
        case ConductTest::repetition:
            return "own repetitions agree with rho " + shortest_digits(*rule.repeat_rho) +
                   " at least";
        case ConductTest::replays:
            return "at most " + shortest_digits(*rule.replays) + " replays a trial on average";
    }
    return {};
}

std::string fault_of(const StudyRecord& record, const ConductRule& rule, ConductTest test) {
    if (!is_on(rule, test)) return {};
    if (test == ConductTest::speed) return fault_of_speed(record, rule);
    const Conduct conduct = conduct_of(record);
    // What is not known (NaN) is below nothing and above nothing.
    if (test == ConductTest::repetition && conduct.repeat_rho < *rule.repeat_rho - kShareSpare) {
        return "own repetitions agree with rho " + significant_digits(conduct.repeat_rho, 2) +
               ", expected " + shortest_digits(*rule.repeat_rho) + " at least";
    }
    if (test == ConductTest::replays && conduct.replays > *rule.replays + kShareSpare) {
        return significant_digits(conduct.replays, 3) +
               " replays a trial on average, expected at most " + shortest_digits(*rule.replays);
    }
    return {};
}

double repeat_rho(std::span<const Judgement> passes) {
    std::vector<double> all;
    for (std::size_t a = 0; a < passes.size(); ++a) {
        for (std::size_t b = a + 1; b < passes.size(); ++b) {
            all.push_back(spearman(passes[a].condensed, passes[b].condensed));
        }
    }
    return mean_known(all);
}

Conduct conduct_of(const StudyRecord& record) {
    std::vector<double> times = response_times_s(record);
    std::ranges::sort(times);
    return {times.size(), times.empty() ? kNoRating : quantile(times, 0.5), mean_replays(record),
            repeat_rho(judgements_of(record, RatingScaling::none))};
}

}  // namespace tact
