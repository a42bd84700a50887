#include "model/perceptual_model/rhythm_envelope.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "model/common/processors.h"
#include "model/signal/four_lanes.h"

namespace tact {

namespace {

constexpr std::size_t kRegisters =
    4;  // at a time: their sums wait for their last terms, not others
constexpr std::size_t kAtOnce = kRegisters * kLanes;

// sums[k] = sizes[k] + .. + sizes[k + kEnvelopeSamples - 1], each summed by itself and in this
// order: a running sum would drift away from silence. A multiple of kAtOnce of them.
//
// One body, compiled for each instruction set it is inlined into.
[[gnu::always_inline]] inline void sum_windows(const double* sizes, std::span<double> sums) {
    for (std::size_t k = 0; k < sums.size(); k += kAtOnce) {
        FourLanes sum[kRegisters] = {};
        for (std::size_t m = 0; m < kEnvelopeSamples; ++m) {
            for (std::size_t r = 0; r < kRegisters; ++r) {
                FourLanes term;
                std::memcpy(&term, sizes + k + m + r * kLanes, sizeof term);
                sum[r] += term;
            }
        }
        std::memcpy(sums.data() + k, sum, sizeof sum);
    }
}

void sum_baseline(const double* sizes, std::span<double> sums) { sum_windows(sizes, sums); }

#ifdef __x86_64__
[[gnu::target("avx2")]] void sum_avx2(const double* sizes, std::span<double> sums) {
    sum_windows(sizes, sums);
}
#endif

}  // namespace

std::span<const WindowSummer> window_summers() {
    static const std::vector<WindowSummer> summers = [] {
        std::vector<WindowSummer> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx2")) usable.push_back({"avx2", sum_avx2});
#endif
        usable.push_back({"baseline", sum_baseline});
        return usable;
    }();
    return summers;
}

std::vector<double> rhythm_envelope(std::span<const double> samples_g,
                                    const EnvelopeParams& params) {
    static const auto sum = kernel_of(window_summers(), simd_wish()).sum;
    const std::size_t n = samples_g.size();
    // A centred window looks half its length ahead.
    const std::size_t ahead =
        params.alignment == EnvelopeAlignment::centred ? kEnvelopeSamples / 2 : 0;
    std::size_t active = n;
    while (active > 0 && samples_g[active - 1] == 0.0) --active;
    // Windows that hold anything, and zeros around the samples: zeros change no sum.
    const std::size_t reach = std::min(active + kEnvelopeSamples, n);
    const std::size_t sums = (reach + kAtOnce - 1) / kAtOnce * kAtOnce;
    const std::size_t before = kEnvelopeSamples - 1 - ahead;
    std::vector<double> sizes(before + std::max(active, sums + kEnvelopeSamples), 0.0);
    for (std::size_t k = 0; k < active; ++k) sizes[before + k] = std::abs(samples_g[k]);
    std::vector<double> envelope(std::max(n, sums), 0.0);
    sum(sizes.data(), std::span(envelope).first(sums));
    envelope.resize(n);
    for (std::size_t k = 0; k < reach; ++k) {
        envelope[k] /= static_cast<double>(kEnvelopeSamples);
    }
    if (params.scale == EnvelopeScale::raw || n == 0) return envelope;
    const double peak = *std::ranges::max_element(envelope);
    if (peak > 0.0) {
        for (double& value : envelope) value /= peak;
    }
    return envelope;
}

std::vector<double> own_rhythm_envelope(std::span<const double> samples_g, std::size_t samples,
                                        const EnvelopeParams& params) {
    std::vector<double> heard(samples_g.begin(), samples_g.end());
    heard.resize(std::min(samples_g.size() + kEnvelopeSamples, samples), 0.0);
    std::vector<double> envelope = rhythm_envelope(heard, params);
    while (!envelope.empty() && envelope.back() == 0.0) envelope.pop_back();
    return envelope;
}

std::vector<double> decimated(std::span<const double> envelope, std::size_t factor,
                              std::size_t samples) {
    samples = std::max(samples, envelope.size());
    std::vector<double> coarse;
    for (std::size_t begin = 0; begin < envelope.size(); begin += factor) {
        const std::size_t end = std::min(begin + factor, samples);
        double sum = 0.0;
        for (std::size_t n = begin; n < std::min(end, envelope.size()); ++n) sum += envelope[n];
        coarse.push_back(sum / static_cast<double>(end - begin));
    }
    return coarse;
}

}  // namespace tact
