#include "model/evaluation/nuisance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/dissimilarity/correlation.h"
#include "model/metrics/level_difference.h"

namespace tact {

std::optional<Dissimilarity> nuisance_named(std::string_view name, const PatternSet& set) {
    const bool is_duration = name == "duration";
    if (!is_duration && name != "level") return std::nullopt;
    std::vector<double> amounts;
    for (const Vibration& vibration : set.vibrations) {
        const Waveform wave = waveform_of(vibration);
        amounts.push_back(is_duration ? sounding_s(wave) : level_db(wave.samples_g));
    }
    Dissimilarity apart{amounts.size(), {}};
    for (std::size_t i = 0; i < amounts.size(); ++i) {
        for (std::size_t j = i + 1; j < amounts.size(); ++j) {
            apart.condensed.push_back(std::abs(amounts[i] - amounts[j]));
        }
    }
    return apart;
}

Given given(const std::string& name, const Dissimilarity& nuisance, const Dissimilarity& ratings,
            const std::vector<Dissimilarity>& metrics, const BootstrapParams& params) {
    Given result{name, spearman(nuisance.condensed, ratings.condensed), {}};
    for (const Dissimilarity& metric : metrics) {
        result.metrics.push_back(
            {partial_spearman(metric.condensed, ratings.condensed, nuisance.condensed),
             partial_bootstrap_interval(metric, ratings, nuisance, params)});
    }
    return result;
}

double sounding_s(const Waveform& waveform) {
    std::size_t count = waveform.samples_g.size();
    while (count > 0 && waveform.samples_g[count - 1] == 0.0) --count;
    return static_cast<double>(count) / waveform.rate_hz;
}

DurationControl duration_control(const Dissimilarity& metric, const Dissimilarity& ratings,
                                 std::span<const double> lasting_s) {
    assert(metric.size == ratings.size && metric.size == lasting_s.size());
    std::vector<double> apart_s;
    std::vector<double> equal_metric;
    std::vector<double> equal_ratings;
    for (std::size_t p = 0; p < metric.condensed.size(); ++p) {
        const auto [i, j] = pair_at(metric.size, p);
        apart_s.push_back(std::abs(lasting_s[i] - lasting_s[j]));
        if (apart_s.back() > 0.0 || !std::isfinite(ratings.condensed[p])) continue;
        equal_metric.push_back(metric.condensed[p]);
        equal_ratings.push_back(ratings.condensed[p]);
    }
    return {equal_metric.size(), spearman(equal_metric, equal_ratings),
            partial_spearman(metric.condensed, ratings.condensed, apart_s),
            spearman(apart_s, ratings.condensed)};
}

std::size_t distinct_values(const Dissimilarity& matrix) {
    std::vector<double> values = quantised(matrix.condensed);
    std::ranges::sort(values);
    const auto end = std::unique(values.begin(), values.end());
    return static_cast<std::size_t>(end - values.begin());
}

}  // namespace tact
