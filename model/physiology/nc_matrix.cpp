#include "model/physiology/nc_matrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tact {

namespace {

constexpr std::size_t kMasks = 1U << kReceptorCount;
constexpr std::size_t kWordBits = 64;
// Rows are zero-padded to the widest register, so that no counter has a remainder.
constexpr std::size_t kRegisterWords = 8;

// One body, compiled for each instruction set that it is inlined into; std::popcount would not be.
// All 16 counts at once, as a register of words then serves four of them.
[[gnu::always_inline]] inline SpikeForm counted(const SpikeRows& a, const SpikeRows& b) {
    const std::size_t words = a.words < b.words ? a.words : b.words;
    SpikeForm counts{};
    for (std::size_t k = 0; k < words; ++k) {
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            for (std::size_t d = 0; d < kReceptorCount; ++d) {
                counts[c][d] +=
                    __builtin_popcountll(a.bits[c * a.words + k] & b.bits[d * b.words + k]);
            }
        }
    }
    return counts;
}

SpikeForm count_baseline(const SpikeRows& a, const SpikeRows& b) { return counted(a, b); }

#ifdef __x86_64__
[[gnu::target("popcnt")]] SpikeForm count_popcnt(const SpikeRows& a, const SpikeRows& b) {
    return counted(a, b);
}

[[gnu::target("avx512f,avx512vpopcntdq,popcnt,prefer-vector-width=512")]] SpikeForm count_avx512(
    const SpikeRows& a, const SpikeRows& b) {
    return counted(a, b);
}
#endif

SpikeForm coincidences(const PackedSpikes& a, const PackedSpikes& b) {
    static const auto count = coincidence_counters().front().count;
    return count({a.bits.data(), a.words}, {b.bits.data(), b.words});
}

// Adds `count` samples at which channels p fire in one pattern and channels q in the other.
void add_case(SpikeForm& form, std::size_t p, std::size_t q, std::int64_t count) {
    const auto difference = [p, q](std::size_t channel) {
        return static_cast<std::int64_t>(p >> channel & 1U) -
               static_cast<std::int64_t>(q >> channel & 1U);
    };
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = 0; d < kReceptorCount; ++d) {
            form[c][d] += difference(c) * difference(d) * count;
        }
    }
}

// Beyond 64 bits: 4 x 4 products of two weights in units of 1e-12 and of up to 1e7 samples.
__extension__ using Wide = __int128;

double root_of(Wide sum, std::size_t samples) {
    if (samples == 0) return 0.0;
    return std::sqrt(static_cast<double>(sum) / static_cast<double>(samples)) / kWeightUnits;
}

}  // namespace

std::int64_t weight_units(double weight) {
    assert(std::abs(weight) <= kLargestWeight && "a weight out of range");
    return std::llround(weight * kWeightUnits);
}

SpikeForm spike_form(const NeuralCode& a, const NeuralCode& b) {
    assert(a.samples == b.samples && "patterns were not padded");
    // A sample of both patterns is one of 16 x 16 cases.
    std::array<std::array<std::int64_t, kMasks>, kMasks> cases{};
    const auto spikes = [](const NeuralCode& code, std::size_t n) {
        return n < code.central_spikes.size() ? code.central_spikes[n] : std::uint8_t{0};
    };
    const std::size_t last = std::max(a.central_spikes.size(), b.central_spikes.size());
    for (std::size_t n = 0; n < last; ++n) ++cases[spikes(a, n)][spikes(b, n)];
    SpikeForm form{};
    for (std::size_t p = 0; p < kMasks; ++p) {
        for (std::size_t q = 0; q < kMasks; ++q) {
            if (cases[p][q] != 0) add_case(form, p, q, cases[p][q]);
        }
    }
    return form;
}

PackedSpikes packed_spikes(const NeuralCode& code) {
    PackedSpikes packed;
    packed.samples = code.samples;
    std::size_t active = code.central_spikes.size();
    while (active > 0 && code.central_spikes[active - 1] == 0) --active;
    const std::size_t registers =
        (active + kRegisterWords * kWordBits - 1) / (kRegisterWords * kWordBits);
    packed.words = registers * kRegisterWords;
    packed.bits.assign(kReceptorCount * packed.words, 0);
    for (std::size_t first = 0; first < active; first += kWordBits) {
        const std::size_t end = std::min(first + kWordBits, active);
        PerReceptor<std::uint64_t> word{};
        for (std::size_t n = first; n < end; ++n) {
            const std::uint64_t mask = code.central_spikes[n];
            for (std::size_t c = 0; c < kReceptorCount; ++c) {
                word[c] |= (mask >> c & 1U) << (n - first);
            }
        }
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            packed.bits[c * packed.words + first / kWordBits] = word[c];
        }
    }
    packed.coincidences = coincidences(packed, packed);
    return packed;
}

SpikeForm spike_form(const PackedSpikes& a, const PackedSpikes& b) {
    assert(a.samples == b.samples && "patterns were not padded");
    const SpikeForm both = coincidences(a, b);
    SpikeForm form;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = 0; d < kReceptorCount; ++d) {
            form[c][d] = a.coincidences[c][d] + b.coincidences[c][d] - both[c][d] - both[d][c];
        }
    }
    return form;
}

PerReceptor<std::int64_t> whole_weights(const PerReceptor<double>& channel_weight) {
    PerReceptor<std::int64_t> weight{};
    std::ranges::transform(channel_weight, weight.begin(),
                           [](double of_channel) { return weight_units(of_channel); });
    return weight;
}

double root_mean_square(std::int64_t unit, std::int64_t sum, std::size_t samples) {
    return root_of(static_cast<Wide>(unit) * unit * sum, samples);
}

double nc_dissimilarity(const SpikeForm& form, std::size_t samples,
                        const PerReceptor<double>& channel_weight) {
    const PerReceptor<std::int64_t> weight = whole_weights(channel_weight);
    Wide sum = 0;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = 0; d < kReceptorCount; ++d) {
            sum += static_cast<Wide>(weight[c]) * weight[d] * form[c][d];
        }
    }
    return root_of(sum, samples);
}

double nc_dissimilarity(const PackedSpikes& a, const PackedSpikes& b,
                        const PerReceptor<double>& channel_weight) {
    return nc_dissimilarity(spike_form(a, b), a.samples, channel_weight);
}

std::span<const CoincidenceCounter> coincidence_counters() {
    static const std::vector<CoincidenceCounter> counters = [] {
        std::vector<CoincidenceCounter> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx512vpopcntdq")) usable.push_back({"avx512", count_avx512});
        if (__builtin_cpu_supports("popcnt")) usable.push_back({"popcnt", count_popcnt});
#endif
        usable.push_back({"baseline", count_baseline});
        return usable;
    }();
    return counters;
}

ChannelShares nc_shares(const SpikeForm& form, const PerReceptor<double>& channel_weight) {
    ChannelShares shares{};
    // The distance itself tells zero from a rounding error.
    if (nc_dissimilarity(form, 1, channel_weight) == 0.0) return shares;
    double sum = 0.0;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = c; d < kReceptorCount; ++d) {
            const double times = c == d ? 1.0 : 2.0;
            shares[c][d] =
                times * channel_weight[c] * channel_weight[d] * static_cast<double>(form[c][d]);
            sum += shares[c][d];
        }
    }
    for (auto& row : shares) {
        for (double& share : row) share /= sum;
    }
    return shares;
}

}  // namespace tact
