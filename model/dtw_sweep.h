// The recurrence of dtw.h along one strip of rows, for the instruction set this is compiled for.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], D[i-1,j], D[i,j-1])
//
// A cell takes five operations; the loop is as fast as they are if no cell waits for another. So a
// strip of rows stays in registers while the columns pass (memory sees one row of a strip), each
// register a little behind the one above it, so that a step's cells need earlier steps only:
//
//     a pair of signals per lane    register k has row k of all, at column t - k
//     a row of one pair per lane    lane l of register k has row r = k lanes + l, at column t - r:
//                                   one operation more, as `above` comes from the lane before
//
// Source    the antidiagonal order: Lipton & Lopresti 1985, "A systolic array for rapid string
//           comparison".
// Exact     the minimum of the same three numbers, the same difference and sum: the order of cells
//           does not change a bit. It must not be compiled with -ffast-math or into other FMAs.
//
// All of it has internal linkage, and nothing of the standard library is in it: the linker must not
// take a function compiled for one instruction set for the same function of another.
#pragma once

#include "model/dtw_kernel.h"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace tact {
namespace {

// As many rows as there are registers for: D at two columns for each of them, and some at work.
#if defined(__AVX512F__)
constexpr std::size_t kLanes = 8;
constexpr std::size_t kRegisters = 8;
#elif defined(__AVX2__)
constexpr std::size_t kLanes = 4;
constexpr std::size_t kRegisters = 5;
#else
constexpr std::size_t kLanes = 2;
constexpr std::size_t kRegisters = 5;
#endif

using Doubles __attribute__((vector_size(8 * kLanes))) = double;
using Bits __attribute__((vector_size(8 * kLanes))) = unsigned long;
// As they lie in memory: at any address of a double.
using Unaligned __attribute__((vector_size(8 * kLanes), aligned(8), may_alias)) = double;

inline Doubles load(const double* from) { return *reinterpret_cast<const Unaligned*>(from); }
inline void store(double* to, Doubles x) { *reinterpret_cast<Unaligned*>(to) = x; }
inline Doubles all(double x) { return x - Doubles{}; }

// x - y and x + y. A product by one is exact, so the fused operation rounds as the plain one does,
// and runs where a processor's minimum does not (a quarter faster on Zen 4).
#if defined(__AVX2__) && !defined(__AVX512F__)
inline Doubles difference(Doubles x, Doubles y) { return _mm256_fmsub_pd(x, all(1.0), y); }
inline Doubles sum(Doubles x, Doubles y) { return _mm256_fmadd_pd(x, all(1.0), y); }
#else
inline Doubles difference(Doubles x, Doubles y) { return x - y; }
inline Doubles sum(Doubles x, Doubles y) { return x + y; }
#endif

// |x - y|: without the sign bit.
inline Doubles apart(Doubles x, Doubles y) {
    return reinterpret_cast<Doubles>(reinterpret_cast<Bits>(difference(x, y)) & ~(1ul << 63));
}

// Numbers that are not negative are in the order of their bits. Where integers have a minimum, it
// is the faster one.
inline Doubles smaller(Doubles x, Doubles y) {
#if defined(__AVX512F__)
    const auto x_bits = reinterpret_cast<Bits>(x);
    const auto y_bits = reinterpret_cast<Bits>(y);
    return reinterpret_cast<Doubles>(x_bits < y_bits ? x_bits : y_bits);
#else
    return x < y ? x : y;
#endif
}

// Each lane from the one before it, the first from the last of `before`.
inline Doubles shifted(Doubles before, Doubles x) {
#if defined(__AVX512F__)
    return __builtin_shufflevector(before, x, 7, 8, 9, 10, 11, 12, 13, 14);
#elif defined(__AVX2__)
    return __builtin_shufflevector(before, x, 3, 4, 5, 6);
#else
    return __builtin_shufflevector(before, x, 1, 2);
#endif
}

enum class Lane { pair, row };

template <Lane lane>
void sweep(const DtwStrip strip) {
    constexpr std::size_t kPairs = lane == Lane::pair ? kLanes : 1;
    constexpr std::size_t kRows = kRegisters * kLanes / kPairs;
    constexpr std::size_t kLast = kRegisters - 1;
    Doubles a[kRegisters];
    Doubles here[kRegisters];        // D[i, j-1], then D[i, j]
    Doubles above_left[kRegisters];  // D[i-1, j-1]
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) {
        a[k] = load(strip.a + k * kLanes);
        here[k] = above_left[k] = all(__builtin_inf());
    }
    for (std::size_t l = 0; l < kPairs; ++l) above_left[0][l] = strip.corner;
    for (std::size_t t = 0; t < strip.steps; ++t) {
        const double* b = strip.b - t * kPairs;
        double* row = strip.row + t * kPairs;
        // From the last register on, as each needs what the one before held a step ago.
#pragma GCC unroll 16
        for (std::size_t up = 0; up < kRegisters; ++up) {
            const std::size_t k = kLast - up;
            Doubles above;
            if constexpr (lane == Lane::pair) {
                above = k == 0 ? load(row) : here[k - 1];
            } else {
                above = shifted(k == 0 ? all(*row) : here[k - 1], here[k]);
            }
            const Doubles cheapest = smaller(smaller(above_left[k], here[k]), above);
            here[k] = sum(apart(load(b + k * kLanes), a[k]), cheapest);
            above_left[k] = above;
        }
        double* finished = row - (kRows - 1) * kPairs;
        if constexpr (lane == Lane::pair) {
            store(finished, here[kLast]);
        } else {
            *finished = here[kLast][kLanes - 1];
        }
    }
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) store(strip.last + k * kLanes, here[k]);
}

constexpr DtwKernel kernel_named(const char* name) {
    return {
        name, {kLanes, kRegisters, sweep<Lane::pair>}, {1, kRegisters * kLanes, sweep<Lane::row>}};
}

}  // namespace
}  // namespace tact
