// A pattern as most formats of the field have it: one amplitude over time, one frequency, bursts.
//
// Several carriers become the strongest one (the first of equals), as loud as all of them together:
// |sum_j w_j exp(i phase_j(t))|, where of each two carriers the beat is kept up to 25 Hz and
// averaged beyond it. A modulation becomes its magnitude, |sin| of a product, up to 25 maxima a
// second; a faster one its mean strength. Where any of these bends, points stand at its extrema and
// zeros and wherever else a straight line would be felt to be off, 2 ms apart at least; all else
// (curves, rhythm, attack and release) is exact.
//
// Source    ours
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Left out  phases; sidebands of what is too fast, but for their energy.
#pragma once

#include <string>
#include <vector>

#include "model/io/effects_out/written_effect.h"
#include "model/pattern/pattern.h"

namespace tact {

struct PlainCurves {
    double duration_s = 0.0;
    AmplitudeCurve amplitude;           // g; from 0 s to the end
    FrequencyCurve frequency;           // at least one point; held outside of them
    std::vector<Transient> transients;  // by time; none of 0 g

    bool operator==(const PlainCurves&) const = default;
};

// What was merged, drawn or left out is added to the remarks, what was thinned to the coarse ones.
PlainCurves as_curves(const Pattern& pattern, WrittenEffect& written);

// The same, with each transient as a pulse: as loud and as high where it is louder than what is
// beneath it. For formats that have none.
PlainCurves with_pulses(PlainCurves curves, std::vector<std::string>& remarks);

}  // namespace tact
