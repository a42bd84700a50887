// The pad of up to four patterns: its corners and the place of the mix.
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

    // The mix, kept until its corners or weights change.
    std::vector<Pattern> mixed_of;
    double mixed_right = -1.0;
    double mixed_down = -1.0;
    Pattern mix;
};

}  // namespace tact
