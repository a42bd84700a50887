// The recurrence of dtw.h along one strip of rows, for the instruction set this is compiled for.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], min(D[i-1,j], D[i,j-1]) + w)
//
// Without w a cell takes five operations; the loop is as fast as they are if no cell waits for
// another. So a strip of rows stays in registers while the columns pass (memory sees one row of a
// strip), each register a little behind the one above it, so that a step's cells need earlier steps
// only:
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

#include "model/dtw/dtw_kernel.h"

#include <cstdint>

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
constexpr std::size_t kRegisters = 6;
#else
constexpr std::size_t kLanes = 2;
constexpr std::size_t kRegisters = 5;
#endif

using Doubles __attribute__((vector_size(8 * kLanes))) = double;
using Bits __attribute__((vector_size(8 * kLanes))) = std::uint64_t;
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
    return reinterpret_cast<Doubles>(reinterpret_cast<Bits>(difference(x, y)) &
                                     ~(std::uint64_t{1} << 63));
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

// What a step that waits costs: nothing, or so much.
struct Free {
    explicit Free(const DtwStrip&) {}
    Doubles least(Doubles above_left, Doubles left, Doubles above) const {
        return smaller(smaller(above_left, left), above);
    }
};
struct AtCost {
    explicit AtCost(const DtwStrip& strip) : cost(all(strip.waiting_cost)) {}
    Doubles least(Doubles above_left, Doubles left, Doubles above) const {
        return smaller(above_left, sum(smaller(left, above), cost));
    }
    Doubles cost;
};

// A cell from the three it can be reached from.
template <class Waiting>
inline Doubles cell(const Waiting& waiting, const double* a, const double* b, Doubles above_left,
                    Doubles left, Doubles above) {
    return sum(apart(load(b), load(a)), waiting.least(above_left, left, above));
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

// One step further along the columns.
inline void advance(DtwStrip& strip, std::size_t pairs) {
    strip.b -= pairs;
    strip.row += pairs;
    --strip.steps;
}

// One step of a pair in every lane. `earlier`, what was reached a step before `reached`, becomes
// what this one reaches: so nothing has to be moved from register to register.
template <class Waiting>
inline void step_of_pairs(const Waiting& waiting, DtwStrip& strip, const Doubles* reached,
                          Doubles* earlier, Doubles& above_left) {
    const Doubles above = load(strip.row);
    // From the last register on, as each needs what the one before it held.
#pragma GCC unroll 16
    for (std::size_t k = kRegisters - 1; k > 0; --k) {
        earlier[k] = cell(waiting, strip.a + k * kLanes, strip.b + k * kLanes, earlier[k - 1],
                          reached[k], reached[k - 1]);
    }
    earlier[0] = cell(waiting, strip.a, strip.b, above_left, reached[0], above);
    above_left = above;
    store(strip.row - (kRegisters - 1) * kLanes, earlier[kRegisters - 1]);
    advance(strip, kLanes);
}

// The state as DtwStrip has it. Above the row of a register is that of the one before.
inline void leave_pairs(const DtwStrip& strip, const Doubles* reached, const Doubles* earlier,
                        Doubles above_left) {
    store(strip.above_left, above_left);
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) {
        store(strip.reached + k * kLanes, reached[k]);
        if (k > 0) store(strip.above_left + k * kLanes, earlier[k - 1]);
    }
}

template <class Waiting>
void sweep_pairs(DtwStrip strip) {
    const Waiting waiting(strip);
    Doubles reached[kRegisters];
    Doubles earlier[kRegisters];
    Doubles above_left = load(strip.above_left);
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) {
        reached[k] = load(strip.reached + k * kLanes);
        const std::size_t below = k + 1 < kRegisters ? k + 1 : k;  // the last is read by none
        earlier[k] = load(strip.above_left + below * kLanes);
    }
    while (strip.steps >= 2) {
        step_of_pairs(waiting, strip, reached, earlier, above_left);
        step_of_pairs(waiting, strip, earlier, reached, above_left);
    }
    if (strip.steps == 0) return leave_pairs(strip, reached, earlier, above_left);
    step_of_pairs(waiting, strip, reached, earlier, above_left);
    leave_pairs(strip, earlier, reached, above_left);
}

// A pair by itself, a row of it in every lane.
template <class Waiting>
void sweep_rows(DtwStrip strip) {
    const Waiting waiting(strip);
    Doubles reached[kRegisters];
    Doubles above_left[kRegisters];
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) {
        reached[k] = load(strip.reached + k * kLanes);
        above_left[k] = load(strip.above_left + k * kLanes);
    }
    while (strip.steps > 0) {
#pragma GCC unroll 16
        for (std::size_t left = kRegisters; left > 0; --left) {
            const std::size_t k = left - 1;
            const Doubles before = k == 0 ? all(*strip.row) : reached[k - 1];
            const Doubles above = shifted(before, reached[k]);
            reached[k] = cell(waiting, strip.a + k * kLanes, strip.b + k * kLanes, above_left[k],
                              reached[k], above);
            above_left[k] = above;
        }
        *(strip.row - (kRegisters * kLanes - 1)) = reached[kRegisters - 1][kLanes - 1];
        advance(strip, 1);
    }
#pragma GCC unroll 16
    for (std::size_t k = 0; k < kRegisters; ++k) {
        store(strip.reached + k * kLanes, reached[k]);
        store(strip.above_left + k * kLanes, above_left[k]);
    }
}

constexpr DtwKernel kernel_named(const char* name) {
    return {name,
            {kLanes, kRegisters, sweep_pairs<Free>, sweep_pairs<AtCost>},
            {1, kRegisters * kLanes, sweep_rows<Free>, sweep_rows<AtCost>}};
}

}  // namespace
}  // namespace tact
