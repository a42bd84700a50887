// Resonances that explain what was measured at all levels in proportion.
//
// What rings for longer than a tone stays is stronger or weaker than its own drive says, and so
// looks out of proportion; what gives out looks like a duller resonance. A resonance is kept where
// each level that counts was measured as it would be, and points that looked out of proportion are
// its own where it explains all of their levels.
//
// Source    ringing.h; the limits are choices of ours
// Input     points as they were measured, which it corrects
#pragma once

#include <vector>

#include "devices/calibration/proportion.h"
#include "devices/calibration/ringing.h"

namespace tact {

std::vector<Resonance> proven_resonances(const CalibrationPlan& plan,
                                         std::vector<MeasuredPoint>& measured);

}  // namespace tact
