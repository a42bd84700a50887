// The inner loops of the search for the model's parameters (training_search.h), one file per
// instruction set, and which of them this processor runs.
//
// Ranks are counted, not sorted: with s the sign, the rank of pair k among m is
//     rank_k = (m + 1 + excess_k) / 2,      excess_k = sum_j s(x_k - x_j)
// which is right for ties too, and the same work for any data, so that many candidates go side by
// side. Spearman's rho needs no more than the excess, which is twice the rank about its mean.
//
// Exact     whole numbers up to the last root and quotient, which IEEE 754 rounds in one way: all
//           of them give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tact {

// Terms of a symmetric 4 x 4 form: w'Fw = sum_t form_t product_t.
inline constexpr std::size_t kFormTerms = 10;

// Mixtures of NC and OC side by side: the paper's 63 proportions of two weights, and NC alone.
inline constexpr std::size_t kMixes = 64;

// NC of all pairs of a set, ranked, for several channel weights side by side.
struct FormBatch {
    std::size_t pairs = 0;
    const std::int32_t* form = nullptr;      // [pair][kFormTerms]
    const std::int32_t* products = nullptr;  // [kFormTerms][weights]
    std::int32_t* value = nullptr;           // [pair][weights], room
    std::int32_t* rank = nullptr;            // [pair][weights], becomes twice the rank
};

// PM of the rated pairs of a set, and how well it agrees with columns of ratings, for kMixes
// mixtures side by side.
//
// The pairs come by ascending OC. Pair k < j then has the smaller PM in every mixture with a share
// of NC, unless its NC is at least that of pair j: only those are counted.
struct MixBatch {
    std::size_t pairs = 0;
    const std::int32_t* nc_rank = nullptr;  // twice the rank
    const std::int32_t* oc_rank = nullptr;  // ascending
    const std::uint64_t* mixed = nullptr;   // [pair k][words]: bit j, j > k with NC not above k's
    std::size_t words = 0;
    const std::int32_t* nc_weight = nullptr;  // [kMixes], whole, not 0
    const std::int32_t* oc_weight = nullptr;
    void* value = nullptr;   // [pair][kMixes] of whole numbers, room aligned for registers
    void* excess = nullptr;  // the same
    std::size_t columns = 0;
    const std::int32_t* ratings = nullptr;  // [column][pair], twice the rank about its mean
    const double* squares = nullptr;        // [column], sum of the squares of those
    double* rho = nullptr;                  // [column][kMixes], becomes rho; NaN: PM has no order
};

struct TrainingKernel {
    const char* name;     // as TACTSPACE_SIMD has it
    std::size_t weights;  // side by side in a FormBatch
    void (*rank_forms)(const FormBatch& batch);
    void (*rank_mixes)(const MixBatch& batch);       // in 16 bits; room of as many
    void (*rank_wide_mixes)(const MixBatch& batch);  // in 32 bits
};

// Whether values and counts stay within 16 bits, and sums of their squares within 32: pairs of the
// set, largest weight.
constexpr bool fits_narrow_mixes(std::size_t pairs, int units) {
    return 4 * pairs * static_cast<std::size_t>(units) + 1 <= 32'767 && pairs <= 1800;
}

// Those this processor can run, the fastest first.
std::span<const TrainingKernel> training_kernels();

// The kernel in use, named by the environment variable TACTSPACE_SIMD; default: the fastest.
const TrainingKernel& training_kernel();

}  // namespace tact
