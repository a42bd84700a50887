// A table of a response made finer where a resonance bends it.
//
// A mass on a spring, S(f) = g / sqrt((1 - u)^2 + u / Q^2) with u = (f0 / f)^2: so 1 / S^2 is a
// parabola in 1 / f^2, whatever g, f0 and Q are, and three points of it give all others. Between
// two points there are two such parabolas, with the next point below or above. Where they agree,
// points are put between until straight lines in log f, log S, as a table is read, follow them to
// 0.25 dB; where they do not, it is no single resonance: the points between are as strong as they
// may be, so that nothing is driven too strongly, and what may be wrong is said. Where that is more
// than 12 dB a point between is not known.
//
// Around a sharp resonance that is known (ringing.h) the points between are its own.
//
// Source    the law of the oscillator; the limits are choices of ours
// Input     a table with its points, frequencies rising
// Output    the same points, with some between that say so
// Left out  two resonances within a few points of each other, but for the remark.
#pragma once

#include <string>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/calibration/proportion.h"
#include "devices/calibration/ringing.h"

namespace tact {

struct FinerTable {
    std::vector<ResponsePoint> points;
    std::vector<std::string> remarks;  // sentences without a full stop
};

FinerTable finer_table(const std::vector<ResponsePoint>& points,
                       const std::vector<Resonance>& known = {});

// Resonances that explain what was measured at all levels in proportion.
//
// What rings for longer than a tone stays is stronger or weaker than its own drive says, and so
// looks out of proportion; what gives out looks like a duller resonance. A resonance is kept where
// each level that counts was measured as it would be, and points that looked out of proportion are
// its own where it explains all of their levels.
//
// Source    ringing.h; the limits are choices of ours
// Input     points as they were measured, which it corrects

std::vector<Resonance> proven_resonances(const CalibrationPlan& plan,
                                         std::vector<MeasuredPoint>& measured);

}  // namespace tact
