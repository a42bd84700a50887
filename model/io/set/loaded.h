// What reading a file gives: the set, and what was odd about the file but accepted.
#pragma once

#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

struct Loaded {
    PatternSet set;
    std::vector<std::string> remarks;  // sentences: resampled, first channel used, padded ..
};

}  // namespace tact
