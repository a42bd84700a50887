#include "model/physiology/brain_units.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/physiology/nc_matrix.h"

namespace tact {

namespace {

// Padding to the widest register, so that no sum has a remainder.
constexpr std::size_t kRegisterValues = 32;

// With fewer sums at a time, this would be slower than counting bits.
constexpr std::size_t kFewestSummed = 2 * kRegisterValues;

// One body, compiled for each instruction set that it is inlined into.
[[gnu::always_inline]] inline std::int64_t summed_products(std::span<const std::int16_t> a,
                                                           std::span<const std::int16_t> b,
                                                           std::size_t summed) {
    const std::size_t both = a.size() < b.size() ? a.size() : b.size();
    std::int64_t total = 0;
    for (std::size_t first = 0; first < both; first += summed) {
        const std::size_t end = first + summed < both ? first + summed : both;
        std::int32_t part = 0;
        for (std::size_t n = first; n < end; ++n) part += std::int32_t{a[n]} * std::int32_t{b[n]};
        total += part;
    }
    return total;
}

std::int64_t sum_baseline(std::span<const std::int16_t> a, std::span<const std::int16_t> b,
                          std::size_t summed) {
    return summed_products(a, b, summed);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] std::int64_t sum_avx2(std::span<const std::int16_t> a,
                                              std::span<const std::int16_t> b, std::size_t summed) {
    return summed_products(a, b, summed);
}

[[gnu::target("avx512bw,prefer-vector-width=512")]] std::int64_t sum_avx512(
    std::span<const std::int16_t> a, std::span<const std::int16_t> b, std::size_t summed) {
    return summed_products(a, b, summed);
}
#endif

std::int64_t product(const BrainUnits& a, const BrainUnits& b, std::size_t summed) {
    static const auto sum = product_summers().front().sum;
    return sum(a.values, b.values, summed);
}

}  // namespace

std::optional<WeightUnits> weight_units(const PerReceptor<double>& channel_weight) {
    WeightUnits units;
    const PerReceptor<std::int64_t> whole = whole_weights(channel_weight);
    std::int64_t divisor = 0;
    for (const std::int64_t weight : whole) divisor = std::gcd(divisor, weight);
    units.unit = std::max<std::int64_t>(divisor, 1);
    std::int64_t largest = 0;  // units of a sample, in absolute value
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        const std::int64_t count = whole[c] / units.unit;
        largest += std::abs(count);
        if (largest > std::numeric_limits<std::int16_t>::max()) return std::nullopt;
        units.weight[c] = static_cast<std::int16_t>(count);
    }
    const auto square = static_cast<std::size_t>(std::max<std::int64_t>(largest * largest, 1));
    const std::size_t fit = std::numeric_limits<std::int32_t>::max() / square;
    units.summed = fit / kRegisterValues * kRegisterValues;
    if (units.summed < kFewestSummed) return std::nullopt;
    return units;
}

BrainUnits brain_units(const NeuralCode& code, const WeightUnits& units) {
    std::array<std::int16_t, 1U << kReceptorCount> value_of{};
    for (std::size_t mask = 0; mask < value_of.size(); ++mask) {
        int value = 0;
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            if ((mask >> c & 1U) != 0) value += units.weight[c];
        }
        value_of[mask] = static_cast<std::int16_t>(value);
    }
    BrainUnits brain;
    brain.samples = code.samples;
    std::size_t active = code.central_spikes.size();
    while (active > 0 && code.central_spikes[active - 1] == 0) --active;
    brain.values.assign((active + kRegisterValues - 1) / kRegisterValues * kRegisterValues, 0);
    for (std::size_t n = 0; n < active; ++n) {
        brain.values[n] = value_of[code.central_spikes[n]];
    }
    brain.square = product(brain, brain, units.summed);
    return brain;
}

double nc_dissimilarity(const BrainUnits& a, const BrainUnits& b, const WeightUnits& units) {
    assert(a.samples == b.samples && "patterns were not padded");
    const std::int64_t apart = a.square + b.square - 2 * product(a, b, units.summed);
    return root_mean_square(units.unit, apart, a.samples);
}

std::span<const ProductSummer> product_summers() {
    static const std::vector<ProductSummer> summers = [] {
        std::vector<ProductSummer> usable;
#ifdef __x86_64__
        if (__builtin_cpu_supports("avx512bw")) usable.push_back({"avx512", sum_avx512});
        if (__builtin_cpu_supports("avx2")) usable.push_back({"avx2", sum_avx2});
#endif
        usable.push_back({"baseline", sum_baseline});
        return usable;
    }();
    return summers;
}

}  // namespace tact
