#include "app/compare/check_morse.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "assets/assets.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/set/set_ratings.h"

namespace tact {

std::optional<MorseCheck> check_morse(const MorseOptions& options) {
    const Expected<PatternSet> set = parse_set(asset(kMorseSet), kMorseSet, {});
    assert(set && "a compiled-in set does not parse");
    const Expected<RatingStudy> study = study_of(*set);
    assert(study && "the set has its ratings");
    EvaluationParams params;
    params.threads = options.threads;
    const Expected<RatedPeople> people = rated_people(*study, params);
    assert(people && "36 patterns are rated, and not alike");
    MetricOptions metric;
    metric.threads = options.threads;
    metric.stop = options.stop;
    metric.progress = options.progress;
    const auto matrices = compared_matrices(*set, kMetrics, nullptr, metric);
    if (!matrices) return std::nullopt;
    std::vector<double> lasting_s;
    for (const Vibration& vibration : set->vibrations) {
        lasting_s.push_back(sounding_s(waveform_of(vibration)));
    }
    const Dissimilarity& ratings = people->rated.people.dissimilarity;
    MorseCheck check{set->vibrations.size(), people->rated_pairs, {}};
    for (std::size_t k = 0; k < kMetrics.size(); ++k) {
        const Dissimilarity& matrix = (*matrices)[k];
        check.rows.push_back({kMetrics[k], evaluate(matrix, people->rated, params),
                              duration_control(matrix, ratings, lasting_s),
                              distinct_values(matrix)});
    }
    const auto order = [](const MorseRow& row) {
        return std::isfinite(row.agreement.rho) ? -row.agreement.rho : 2.0;
    };
    std::ranges::stable_sort(check.rows, {}, order);
    return check;
}

}  // namespace tact
