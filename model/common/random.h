// Random numbers by position in a stream, so that work shared among threads draws the same ones.
//
// Source    SplitMix64 (Steele, Lea & Flood 2014); polar method (Marsaglia & Bray 1964); shuffle
//           (Durstenfeld 1964).
// Exact     same seed, same numbers, whatever the thread and the standard library.
// Left out  protection against someone who looks for patterns.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "model/common/portable.h"

namespace tact {

// The counter-th number of a stream; also, of a seed, its counter-th stream.
constexpr std::uint64_t random_bits(std::uint64_t stream, std::uint64_t counter) {
    std::uint64_t z = stream + (counter + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

// Numbers one after the other.
struct RandomStream {
    std::uint64_t stream = 0;
    std::uint64_t counter = 0;
};

// Even in [-1, 1).
inline double next_even(RandomStream& random) {
    return static_cast<double>(random_bits(random.stream, random.counter++) >> 11U) * 0x1p-52 - 1.0;
}

// Even among 0 .. count - 1, for counts far below 2^32; 0 for none.
inline std::size_t next_index(RandomStream& random, std::size_t count) {
    const std::uint64_t bits = random_bits(random.stream, random.counter++) >> 32U;
    return static_cast<std::size_t>((bits * count) >> 32U);
}

// Standard normal.
inline double next_normal(RandomStream& random) {
    for (;;) {
        const double u = next_even(random);
        const double v = next_even(random);
        const double s = u * u + v * v;
        if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * portable::log(s) / s);
    }
}

// 0 .. size - 1 in any order, each as likely.
inline void next_permutation_of(RandomStream& random, std::span<std::size_t> order) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t k = order.size(); k > 1; --k) {
        std::swap(order[k - 1], order[next_index(random, k)]);
    }
}

}  // namespace tact
