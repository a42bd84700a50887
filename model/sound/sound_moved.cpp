#include "model/sound/sound_moved.h"

#include <algorithm>
#include <cassert>

#include "model/export/ranks_among.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/rank_sum.h"
#include "model/set/set_waveforms.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSame = 1e-4;  // of the yardstick's largest NC or OC

std::vector<double> section_of(const std::vector<double>& x, std::size_t first, std::size_t count) {
    std::vector<double> section(count, 0.0);
    for (std::size_t n = first; n < std::min(first + count, x.size()); ++n) {
        section[n - first] = x[n];
    }
    return section;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double pm_among(const Prediction& yardstick, double nc, double oc) {
    const auto is_same = [](double value, const Dissimilarity& among) {
        return value <= kSame * std::ranges::max(among.condensed);
    };
    if (is_same(nc, yardstick.nc) && is_same(oc, yardstick.oc)) return 0.0;
    return pm_of(ranks_among(std::vector{nc}, yardstick.nc.condensed).front(),
                 ranks_among(std::vector{oc}, yardstick.oc.condensed).front(),
                 yardstick.params.nc_weight, yardstick.params.oc_weight);
}

}  // namespace

std::optional<SoundMoved> sound_moved(const Waveform& felt, const Pattern& pattern,
                                      const PatternSet& yardstick,
                                      const SoundMovedOptions& options) {
    assert(yardstick.vibrations.size() >= 3);
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    const auto known = predict(own_waveforms(yardstick, options.threads), yardstick.model, how);
    if (!known) return std::nullopt;
    const Waveform rendered = render(pattern);
    const std::size_t count = longest_samples(yardstick);
    const std::size_t samples = std::max(felt.samples_g.size(), rendered.samples_g.size());
    SoundMoved moved{yardstick.name, longest_s(yardstick), {}, 0.0, 0.0};
    for (std::size_t first = 0; first < samples; first += count) {
        const std::vector<Waveform> both{
            {kModelRateHz, section_of(felt.samples_g, first, count)},
            {kModelRateHz, section_of(rendered.samples_g, first, count)}};
        const auto codes = pattern_codes(both, yardstick.model, how);
        if (options.stop.stop_requested() || codes.size() != 2) return std::nullopt;
        moved.pm.push_back(pm_among(*known, nc_matrix(codes, yardstick.model, how).condensed[0],
                                    oc_matrix(codes, yardstick.model, how).condensed[0]));
        if (options.stop.stop_requested()) return std::nullopt;
        if (options.progress) {
            options.progress(
                std::min(1.0, static_cast<double>(first + count) / static_cast<double>(samples)));
        }
    }
    moved.closest_pm = std::ranges::min(known->pm.condensed);
    moved.farthest_pm = std::ranges::max(known->pm.condensed);
    return moved;
}

std::string words_on(const SoundMoved& moved) {
    if (moved.pm.empty()) return {};
    const auto most = std::ranges::max_element(moved.pm);
    std::string words = "PM from the sound " + significant_digits(mean_of(moved.pm), 3);
    if (moved.pm.size() > 1) {
        const double from_s = moved.section_s * static_cast<double>(most - moved.pm.begin());
        words += " on the whole, at most " + significant_digits(*most, 3) + " (" +
                 significant_digits(from_s, 3) + " to " +
                 significant_digits(from_s + moved.section_s, 3) + " s)";
    }
    return words + "; the pairs of " + moved.yardstick + " have " +
           significant_digits(moved.closest_pm, 3) + " to " +
           significant_digits(moved.farthest_pm, 3);
}

}  // namespace tact
