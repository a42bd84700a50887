// Fill the gap: those of many patterns that lie farthest from all that are picked.
//
// All are compared at once, and PM is that of the set of all of them. The weakest of the pairs that
// have a new pattern in them is made as strong as can be.
//
// Source    ours; max-min dispersion: model/subset
// Valid     one picked pattern or more; of candidates no more than are missing: all of them
// Exact     same question, same answer, on any number of threads.
// Left out  what the PM will be in the set with the new ones alone
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/pattern/felt_steps.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"

namespace tact {

struct GapQuestion {
    std::vector<Vibration> picked;
    std::vector<Pattern> candidates;
    std::size_t missing = 1;
    PerceptualModelParams model{};
    bool coarse = false;  // by coarse envelopes: a preview

    bool operator==(const GapQuestion&) const = default;
};

struct GapOptions {
    int threads = 0;                                                // 0: all cores
    double time_limit_s = std::numeric_limits<double>::infinity();  // of the search
    std::stop_token stop{};
    std::function<void(double)> progress{};           // 0..1, from any thread
    std::function<Waveform(const Waveform&)> felt{};  // where a device plays it; none: itself
};

struct GapAnswer {
    std::vector<std::size_t> chosen;  // of the candidates, ascending
    double weakest_pm = 0.0;          // of the pairs that have a new one in them
    double largest_pm = 0.0;          // of all that were compared
    bool is_proven = false;           // no other choice of these candidates is better
};

// None when stopped; nothing chosen where there are no candidates.
std::optional<GapAnswer> fill_gap(const GapQuestion& question, const GapOptions& options);

// The same of a matrix whose first rows are picked and whose others are the candidates.
std::optional<GapAnswer> fill_gap(const Dissimilarity& pm, std::size_t picked, std::size_t missing,
                                  const GapOptions& options);

// What could fill a gap: the patterns of a set's design space; without one, patterns drawn around
// those that are picked.
//
// Source    ours
// Exact     same input, same patterns.
// Left out  patterns longer than the set's longest: all others would have to be compared again

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
