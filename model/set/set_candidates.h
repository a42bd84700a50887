// Candidates of a design space on their way into a set: which of them are new to it, what they take
// the place of, and under which names they stand there.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/design_space/candidates.h"
#include "model/set/pattern_set.h"

namespace tact {

// What happens to candidates generated before and not changed by hand since.
enum class Before {
    kept,
    replaced  // but for locked ones
};

bool is_replaced(const Vibration& vibration, Before before);

// The candidates that are not in the set already, whatever they are called there.
std::vector<Candidate> new_to(const PatternSet& set, const std::vector<Candidate>& candidates,
                              Before before);

// Short names, one series a generation: A01, A02, ...; B01, ... where the set has names with A.
// What they stand for is told by level_words().
class ShortNames {
  public:
    ShortNames(const PatternSet& set, std::size_t count);
    std::string next();

  private:
    std::string letter_ = "A";
    std::size_t digits_ = 2;
    std::size_t last_ = 0;
};

// The set with its generator and, behind what it has, these candidates under short free names. An
// Error where that would be more patterns than a set can have.
Expected<PatternSet> with_candidates(PatternSet set, const DesignSpace& space,
                                     const std::vector<Candidate>& fresh, Before before);

}  // namespace tact
