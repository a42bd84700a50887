// Sets with their ratings, and how metrics agree with these: the work behind compare and paper.
#pragma once

#include <vector>

#include "app/command_line/agreement/set_agreement.h"
#include "app/command_line/commands.h"
#include "model/common/expected.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ComparedSet {
    PatternSet set;
    SetAgreement agreement;  // of its rated patterns
};

// In the order of the command's sets. Errors: as load_rated(); a metric or a nuisance that is not
// known or cannot be read.
Expected<std::vector<ComparedSet>> compared_sets(const CompareCommand& command);

}  // namespace tact
