// What could fill a gap: the patterns of a set's design space; without one, patterns drawn around
// those that are picked.
//
// Source    ours
// Exact     same input, same patterns.
// Left out  patterns longer than the set's longest: all others would have to be compared again
#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "model/pattern/felt_steps.h"
#include "model/set/pattern_set.h"

namespace tact {

// More of a design space are drawn from it at random.
inline constexpr std::size_t kMostGapCandidates = 240;

// How many are drawn where there is no design space, and how far from the picked ones at most.
inline constexpr std::size_t kDrawnGapCandidates = 96;
inline constexpr double kFarthestDrawnSteps = 20.0;

struct GapCandidates {
    std::vector<Pattern> patterns;  // none is a picked one
    bool of_space = false;          // of the set's design space
    bool all_there_are = false;     // the space is finite, and these are all of it
};

// `picked`: places in the set. `free`: the numbers that may change where there is no space; empty:
// all. Few when stopped.
GapCandidates gap_candidates(const PatternSet& set, const std::vector<std::size_t>& picked,
                             const std::vector<PatternParameter>& free, std::uint64_t seed,
                             std::stop_token stop = {});

}  // namespace tact
