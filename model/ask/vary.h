// Neighbours of a pattern: as far from it as asked for, and as far from each other as can be.
//
// Directions are drawn at random in felt steps of the numbers that are free; of those drawn, the
// ones that lie farthest apart to the model (NC and OC before ranks, coarse envelopes) are taken.
//
// Source    ours; taking the farthest next: Gonzalez 1985
// Left out  rhythms' notes and what is drawn
// Exact     same question, same answer, on any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/common/random.h"
#include "model/pattern/felt_steps.h"
#include "model/perceptual_model/perceptual_model.h"

namespace tact {

struct VaryQuestion {
    Pattern pattern;
    std::vector<PatternParameter> free{};  // empty: all that it has
    double how_far = 3.0;                  // felt steps, all numbers together
    std::size_t count = 8;
    std::uint64_t seed = 1;
    FeltSteps steps{};
    PerceptualModelParams model{};

    bool operator==(const VaryQuestion&) const = default;
};

// None when stopped; fewer than asked for where next to nothing is free.
std::optional<std::vector<Pattern>> varied(const VaryQuestion& question, int threads,
                                           std::stop_token stop);

// Numbers of the pattern that may change: it has them, and they are among `free`, or that is empty.
std::vector<PatternParameter> free_numbers(const Pattern& pattern,
                                           const std::vector<PatternParameter>& free);

// A pattern `how_far` felt steps away, in a direction drawn from the stream.
Pattern stepped_at_random(const Pattern& pattern, const std::vector<PatternParameter>& free,
                          const FeltSteps& steps, double how_far, RandomStream& random);

}  // namespace tact
