// The pad of up to four patterns: which they are, and where in it the mix is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/morph/pad.h"

namespace tact {

struct PadState {
    std::vector<std::string> corners;  // names
    double right = 0.5;
    double down = 0.5;

    // The mix, kept while what it is of stays.
    std::vector<Pattern> mixed_of;
    double mixed_right = -1.0;
    double mixed_down = -1.0;
    Pattern mix;
};

}  // namespace tact
