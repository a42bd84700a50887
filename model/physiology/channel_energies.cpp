#include "model/physiology/channel_energies.h"

#include <algorithm>
#include <array>
#include <memory>

#include "model/common/processors.h"
#include "model/physiology/spike_train.h"
#include "model/signal/four_lanes.h"
#include "model/signal/waveform.h"

namespace tact {

namespace {

static_assert(kReceptorCount == kLanes, "a lane for each channel");

struct FourSections {
    FourLanes b0, b1, b2, a1, a2;
    FourLanes first{}, second{};  // state of the filter
};

// A filter with fewer sections is padded with sections that pass their input. They may turn -0 into
// 0, which no square tells apart.
std::vector<FourSections> side_by_side(const NeuralCodingParams& params) {
    constexpr Section kPassing{1.0, 0.0, 0.0, 0.0, 0.0};
    PerReceptor<std::vector<Section>> filters;
    std::size_t most = 0;
    for (const Receptor receptor : kReceptors) {
        filters[index_of(receptor)] = channel_sections(receptor, params);
        most = std::max(most, filters[index_of(receptor)].size());
    }
    std::vector<FourSections> all(most);
    for (std::size_t c = 0; c < kLanes; ++c) {
        filters[c].resize(most, kPassing);
        for (std::size_t k = 0; k < most; ++k) {
            all[k].b0[c] = filters[c][k].b0;
            all[k].b1[c] = filters[c][k].b1;
            all[k].b2[c] = filters[c][k].b2;
            all[k].a1[c] = filters[c][k].a1;
            all[k].a2[c] = filters[c][k].a2;
        }
    }
    return all;
}

struct Filtered {
    std::unique_ptr<FourValues[]> samples;
    FourLanes energy{};
    FourLanes peak{};
};

// One body, compiled for each instruction set that it is inlined into; `Sections` 0: any number.
template <std::size_t Sections>
[[gnu::always_inline]] inline void filter_all(std::span<const double> input_g,
                                              std::span<FourSections> sections,
                                              Filtered& filtered) {
    const std::size_t count = Sections == 0 ? sections.size() : Sections;
    FourSections* const section = sections.data();
    for (std::size_t n = 0; n < input_g.size(); ++n) {
        const double sample = input_g[n];
        FourLanes value{sample, sample, sample, sample};
        for (std::size_t k = 0; k < count; ++k) {
            FourSections& one = section[k];
            const FourLanes out = one.b0 * value + one.first;
            one.first = one.b1 * value - one.a1 * out + one.second;
            one.second = one.b2 * value - one.a2 * out;
            value = out;
        }
        filtered.samples[n].lanes = value;
        filtered.energy += value * value;
        const FourLanes size = value < 0.0 ? -value : value;
        filtered.peak = filtered.peak < size ? size : filtered.peak;
    }
}

// The sum of squares up to the end of each window of the perceived waveform: normalised, and
// differentiated if a channel adapts.
[[gnu::always_inline]] inline void sum_windows(const FourValues* samples, std::size_t count,
                                               const FourLanes& peak, const FourChoices& adapts,
                                               std::span<FourValues> energies) {
    const FourLanes rate = {kModelRateHz, kModelRateHz, kModelRateHz, kModelRateHz};
    FourLanes previous{};
    FourLanes energy{};
    for (std::size_t window = 0; window < energies.size(); ++window) {
        const std::size_t begin = window * kWindowSamples;
        const std::size_t end = begin + kWindowSamples < count ? begin + kWindowSamples : count;
        for (std::size_t n = begin; n < end; ++n) {
            const FourLanes sample = samples[n].lanes / peak;
            const FourLanes change = (sample - previous) * rate;
            const FourLanes perceived = adapts ? change : sample;
            energy += perceived * perceived;
            previous = sample;
        }
        energies[window].lanes = energy;
    }
}

constexpr std::size_t kUsualSections = 5;  // for the default orders

[[gnu::always_inline]] inline PerReceptor<std::vector<double>> energy_fractions_of(
    std::span<const double> input_g, double input_energy, const NeuralCodingParams& params) {
    std::vector<FourSections> sections = side_by_side(params);
    Filtered filtered;
    filtered.samples = std::make_unique_for_overwrite<FourValues[]>(input_g.size());
    if (sections.size() == kUsualSections) {
        filter_all<kUsualSections>(input_g, sections, filtered);
    } else {
        filter_all<0>(input_g, sections, filtered);
    }
    FourChoices adapts{};
    std::array<bool, kLanes> sounds{};
    for (std::size_t c = 0; c < kLanes; ++c) {
        adapts[c] = traits(kReceptors[c]).rapidly_adapting ? -1 : 0;
        const bool silent = filtered.energy[c] <= params.silent_energy_fraction * input_energy;
        sounds[c] = !silent && filtered.peak[c] != 0.0;
        if (!sounds[c]) filtered.peak[c] = 1.0;
    }
    std::vector<FourValues> energies(window_count(input_g.size()));
    sum_windows(filtered.samples.get(), input_g.size(), filtered.peak, adapts, energies);
    PerReceptor<std::vector<double>> fractions;
    for (std::size_t c = 0; c < kLanes; ++c) {
        fractions[c].assign(energies.size(), 0.0);
        const double all = energies.empty() ? 0.0 : energies.back().lanes[c];
        if (!sounds[c] || !(all > 0.0)) continue;
        for (std::size_t window = 0; window < energies.size(); ++window) {
            fractions[c][window] = energies[window].lanes[c] / all;
        }
    }
    return fractions;
}

PerReceptor<std::vector<double>> run_baseline(std::span<const double> input_g, double input_energy,
                                              const NeuralCodingParams& params) {
    return energy_fractions_of(input_g, input_energy, params);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] PerReceptor<std::vector<double>> run_avx2(
    std::span<const double> input_g, double input_energy, const NeuralCodingParams& params) {
    return energy_fractions_of(input_g, input_energy, params);
}
#endif

}  // namespace

std::vector<Section> channel_sections(Receptor receptor, const NeuralCodingParams& params) {
    const ReceptorTraits& type = traits(receptor);
    return type.low_hz > 0.0
               ? band_pass(params.band_pass_order_per_edge, type.low_hz, type.high_hz, kModelRateHz)
               : low_pass(params.low_pass_order, type.high_hz, kModelRateHz);
}

PerReceptor<std::vector<double>> channel_energy_fractions(std::span<const double> input_g,
                                                          double input_energy,
                                                          const NeuralCodingParams& params) {
    static const auto run = kernel_of(channel_runners(), simd_wish()).run;
    return run(input_g, input_energy, params);
}

std::span<const ChannelRunner> channel_runners() {
    static const std::vector<ChannelRunner> runners = [] {
        std::vector<ChannelRunner> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx2")) usable.push_back({"avx2", run_avx2});
#endif
        usable.push_back({"baseline", run_baseline});
        return usable;
    }();
    return runners;
}

}  // namespace tact
