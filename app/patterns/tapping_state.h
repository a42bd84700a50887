// Taps that are being made.
#pragma once

#include <optional>
#include <vector>

#include "model/pattern/tapped_rhythm.h"

namespace tact {

struct TappingState {
    std::vector<Tap> taps;         // by the window's clock
    std::optional<double> down_s;  // since when the key or the button is held
    std::optional<double> step_s;  // by hand; none: estimated
    bool has_opened = true;        // the key that opened the dialog may still be held: no note
};

}  // namespace tact
