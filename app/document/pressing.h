// A pattern that the mouse is pressed on, wherever it is shown: held for a while, it is felt as
// long as it is held (app/play).
#pragma once

#include "app/document/workspace.h"
#include "model/set/pattern_set.h"

namespace tact {

// Longer than a click or the start of a drag takes.
inline constexpr double kHoldS = 0.25;
inline constexpr const char* kHoldHelp = "Hold for 0.25 s: felt as long as it is held";

// In this frame. A drag is no press: it moves what it began on.
void note_pressed(Workspace& work, const Vibration& vibration);

}  // namespace tact
