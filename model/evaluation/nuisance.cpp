#include "model/evaluation/nuisance.h"

#include <cmath>

#include "model/evaluation/duration_control.h"
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

}  // namespace tact
