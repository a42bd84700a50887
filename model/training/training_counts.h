// Ranks by counting signs, as training_kernel.h has them, for the instruction set this is compiled
// for.
//
// With y = x_k + 1 and whole x, sign(x_k - x_j) + 1 is y - x_j kept within 0 and 2: two operations
// where registers subtract with a floor of zero. Every pair counts as above all before it and below
// all after it from the start, so that just that number is added for those that are not.
//
// All of it has internal linkage, and nothing of the standard library is in it: the linker must not
// take a function compiled for one instruction set for the same function of another.
#pragma once

#include "model/training/training_kernel.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace tact {
namespace {

#if defined(__AVX512BW__)
constexpr std::size_t kBytes = 64;
#elif defined(__AVX2__)
constexpr std::size_t kBytes = 32;
#else
constexpr std::size_t kBytes = 16;
#endif

using Shorts __attribute__((vector_size(kBytes))) = std::int16_t;
using Ints __attribute__((vector_size(kBytes))) = std::int32_t;

constexpr std::size_t kWeights = kBytes / sizeof(std::int32_t);

// y - x kept within 0 and 2.
inline Ints order_of(Ints y, Ints x) {
    const Ints two = Ints{} + 2;
    const Ints above = (y > x ? y : x) - x;
    return above < two ? above : two;
}

inline Shorts order_of(Shorts y, Shorts x) {
    const Shorts two = Shorts{} + 2;
#if defined(__AVX512BW__)
    const auto above = (Shorts)_mm512_subs_epu16((__m512i)y, (__m512i)x);
#elif defined(__AVX2__)
    const auto above = (Shorts)_mm256_subs_epu16((__m256i)y, (__m256i)x);
#elif defined(__SSE2__)
    const auto above = (Shorts)_mm_subs_epu16((__m128i)y, (__m128i)x);
#else
    const Shorts above = (y > x ? y : x) - x;
#endif
    return above < two ? above : two;
}

void rank_forms(const FormBatch& batch) {
    const auto* products = reinterpret_cast<const Ints*>(batch.products);
    auto* value = reinterpret_cast<Ints*>(batch.value);
    auto* rank = reinterpret_cast<Ints*>(batch.rank);
    for (std::size_t k = 0; k < batch.pairs; ++k) {
        const std::int32_t* form = batch.form + k * kFormTerms;
        Ints sum{};
        for (std::size_t t = 0; t < kFormTerms; ++t) sum += form[t] * products[t];
        value[k] = sum;
        // Twice the rank is pairs + 1 + excess; of those before, all count as smaller for now.
        rank[k] = Ints{} + static_cast<std::int32_t>(2 * (k + 1));
    }
    for (std::size_t k = 0; k < batch.pairs; ++k) {
        const Ints y = value[k] + 1;
        Ints of_k = rank[k];
        for (std::size_t j = k + 1; j < batch.pairs; ++j) {
            const Ints order = order_of(y, value[j]);
            of_k += order;
            rank[j] -= order;
        }
        rank[k] = of_k;
    }
}

// One group of registers of mixtures; `from`: the first of them.
template <class Number, class Numbers, std::size_t kGroup, std::size_t kAcross>
inline void count_signs(const MixBatch& batch, std::size_t from) {
    const auto* value = static_cast<const Numbers*>(batch.value) + from;
    auto* excess = static_cast<Numbers*>(batch.excess) + from;
    for (std::size_t k = 0; k < batch.pairs; ++k) {
        Numbers y[kGroup];
        Numbers ahead[kGroup];
        const int after = static_cast<int>(2 * k + 1) - static_cast<int>(batch.pairs);
#pragma GCC unroll 8
        for (std::size_t v = 0; v < kGroup; ++v) {
            y[v] = value[k * kAcross + v] + 1;
            ahead[v] = Numbers{} + static_cast<Number>(after);
        }
        for (std::size_t word = k / 64; word < batch.words; ++word) {
            std::uint64_t bits = batch.mixed[k * batch.words + word];
            for (; bits != 0; bits &= bits - 1) {
                const std::size_t j = 64 * word + static_cast<std::size_t>(__builtin_ctzll(bits));
#pragma GCC unroll 8
                for (std::size_t v = 0; v < kGroup; ++v) {
                    const Numbers order = order_of(y[v], value[j * kAcross + v]);
                    ahead[v] += order;
                    excess[j * kAcross + v] += order;
                }
            }
        }
        // So far what those before have passed it by.
#pragma GCC unroll 8
        for (std::size_t v = 0; v < kGroup; ++v) {
            excess[k * kAcross + v] = ahead[v] - excess[k * kAcross + v];
        }
    }
}

// From the excesses to rho. Sums of whole numbers: in 32 bits where excesses have 16.
template <class Number, class Sum>
inline void correlate(const MixBatch& batch) {
    const auto* excess = static_cast<const Number*>(batch.excess);
    Sum squares[kMixes] = {};
    for (std::size_t k = 0; k < batch.pairs; ++k) {
        for (std::size_t l = 0; l < kMixes; ++l) {
            const Sum e = excess[k * kMixes + l];
            squares[l] += e * e;
        }
    }
    for (std::size_t c = 0; c < batch.columns; ++c) {
        Sum products[kMixes] = {};
        const std::int32_t* ratings = batch.ratings + c * batch.pairs;
        for (std::size_t k = 0; k < batch.pairs; ++k) {
            const auto rating = static_cast<Number>(ratings[k]);
            for (std::size_t l = 0; l < kMixes; ++l) {
                products[l] += static_cast<Sum>(excess[k * kMixes + l]) * rating;
            }
        }
        double* rho = batch.rho + c * kMixes;
        for (std::size_t l = 0; l < kMixes; ++l) {
            const double size = __builtin_sqrt(static_cast<double>(squares[l]) * batch.squares[c]);
            const double r = static_cast<double>(products[l]) / size;
            rho[l] = r > 1.0 ? 1.0 : (r < -1.0 ? -1.0 : r);
        }
    }
}

template <class Number, class Numbers, class Sum>
void rank_mixes(const MixBatch& batch) {
    constexpr std::size_t kAcross = kMixes * sizeof(Number) / kBytes;
    constexpr std::size_t kGroup = kAcross < 4 ? kAcross : 4;  // as there are registers for
    auto* value = static_cast<Number*>(batch.value);
    auto* excess = static_cast<Number*>(batch.excess);
    Number nc_weight[kMixes];
    Number oc_weight[kMixes];
    for (std::size_t l = 0; l < kMixes; ++l) {
        nc_weight[l] = static_cast<Number>(batch.nc_weight[l]);
        oc_weight[l] = static_cast<Number>(batch.oc_weight[l]);
    }
    for (std::size_t k = 0; k < batch.pairs; ++k) {
        const auto nc = static_cast<Number>(batch.nc_rank[k]);
        const auto oc = static_cast<Number>(batch.oc_rank[k]);
        for (std::size_t l = 0; l < kMixes; ++l) {
            value[k * kMixes + l] = static_cast<Number>(nc_weight[l] * nc + oc_weight[l] * oc);
            excess[k * kMixes + l] = 0;
        }
    }
    for (std::size_t from = 0; from < kAcross; from += kGroup) {
        count_signs<Number, Numbers, kGroup, kAcross>(batch, from);
    }
    correlate<Number, Sum>(batch);
}

constexpr TrainingKernel kernel_named(const char* name) {
    return {name, kWeights, rank_forms, rank_mixes<std::int16_t, Shorts, std::int32_t>,
            rank_mixes<std::int32_t, Ints, std::int64_t>};
}

}  // namespace
}  // namespace tact
