// The vibrations of a design space: combined, freed of doubles, held to the constraints, named.
//
// Output    in the design's order; every combination is kept, a double of an earlier one, or
//           rejected by the first constraint it fails, in the order of `Rejections`
// Valid     a design without fault
// Exact     same space, same candidates, on every machine that rounds as IEEE 754 says (ranges in
//           ratios: up to the last digit of std::pow).
// Left out  filling up: what is left out of a sample is not drawn again.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "model/design_space.h"
#include "model/expected.h"
#include "model/mechanoreceptor.h"
#include "model/pattern_set.h"

namespace tact {

struct Candidate {
    std::string name;  // tells the levels: "0.5g 150Hz mod4Hz x=--"; unique
    Pattern pattern;
};

struct Rejections {
    std::size_t band = 0;
    std::size_t displacement = 0;
    std::size_t detectability = 0;
};

struct Candidates {
    std::vector<Candidate> kept;
    std::size_t combinations = 0;
    std::size_t doubles = 0;  // of others among them
    Rejections rejected;
};

std::size_t total(const Rejections& rejected);

// An Error is the design's fault, as a sentence. Few when stopped: nobody waits for them.
Expected<Candidates> candidates(const DesignSpace& space, const PhysiologyTables& tables,
                                std::stop_token stop = {});

// What becomes of those that were generated before, and not changed by hand since.
enum class Before {
    kept,
    replaced  // but for locked ones
};

bool is_replaced(const Vibration& vibration, Before before);

// The candidates that are not in the set already, whatever they are called there.
std::vector<Candidate> new_to(const PatternSet& set, const std::vector<Candidate>& candidates,
                              Before before);

// The set with its generator and, behind what it has, these candidates under free names. An Error
// where that would be more patterns than a set can have.
Expected<PatternSet> with_candidates(PatternSet set, const DesignSpace& space,
                                     const std::vector<Candidate>& fresh, Before before);

}  // namespace tact
