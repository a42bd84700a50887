// The vibrations of a design space: combined, freed of doubles, held to the constraints, named.
//
// Output    in the design's order; every combination is kept, a double of an earlier one, or
//           rejected by the first constraint it fails, in the order of `Rejections`
// Valid     a design without fault
// Exact     same space, same candidates, on every machine that rounds as IEEE 754 says.
// Left out  filling up: what is left out of a sample is not drawn again.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/design_space/design_space.h"
#include "model/pattern/pattern.h"
#include "model/physiology/mechanoreceptor.h"

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

// The levels in words, as a candidate of this space is called: "0.5g 150Hz mod4Hz x=--". Where
// nothing varies: "candidate".
std::string level_words(const DesignSpace& space, const Pattern& pattern);

// An Error is the design's fault, as a sentence. Few when stopped: nobody waits for them.
Expected<Candidates> candidates(const DesignSpace& space, const PhysiologyTables& tables,
                                std::stop_token stop = {});

}  // namespace tact
