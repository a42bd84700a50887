// Patterns on which two metrics disagree most: those whose ratings can decide between them.
//
// Source    ours: the subset whose pairs have the lowest Spearman's rho between the two, by
//           exchanges of one pattern from random starts; of equals the first found
// Input     two matrices of the same patterns
// Output    places in rising order, and the rho that is left
// Left out  a proof that no subset has a lower rho; what people would feel, which nobody knows yet.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

struct DecidingParams {
    std::size_t starts = 20;
    std::uint64_t seed = 13;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};
};

struct DecidingPatterns {
    std::vector<std::size_t> patterns;
    double rho = 0.0;      // between the two on these; NaN: one of them is constant there
    double rho_all = 0.0;  // on all patterns
};

// `count`: 3 to all of them. None when stopped.
std::optional<DecidingPatterns> deciding_patterns(const Dissimilarity& one,
                                                  const Dissimilarity& other, std::size_t count,
                                                  const DecidingParams& params = {});

}  // namespace tact
