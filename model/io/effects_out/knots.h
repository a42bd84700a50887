// Amplitude and frequency in the same points, few and far between: for formats that have them so.
//
// From the two ends on, a point is added where the lines are farthest off for who feels them, if
// there is room for it: Ramer, Douglas and Peucker's way, with a least distance between points.
// Where nothing is felt, the numbers decide.
//
// A player that begins in silence gets there within the first gap: what is loudest in it and over
// before is played at its end.
//
// Source    model/signal/thinning.h, for two heights at once; shares.h
// Left out  how far off the result is: model/export/envelope_error.h
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/io/effects_out/shares.h"
#include "model/pattern/curves.h"

namespace tact {

struct Knot {
    double time_s = 0.0;
    double amplitude = 0.0;
    double frequency = 0.0;

    bool operator==(const Knot&) const = default;
};

struct KnotRules {
    std::size_t most = 16;
    double least_gap_s = 0.020;
    double tick_s = 0.001;                        // times are whole ones
    double frequency_unit = 1.0;                  // that counts as much as an amplitude of 1
    double tolerance = 0.0;                       // of which no more points are needed
    bool from_silence = false;                    // its player begins at amplitude 0
    double frequency_step = 0.0;                  // frequencies are whole ones of this; 0: any
    std::function<FeltTone(const Knot&)> felt{};  // in g and Hz; empty: the numbers alone decide
};

struct FittedKnots {
    std::vector<Knot> knots;  // from 0 s to the end
    std::size_t points = 0;   // of the curves, together
    std::size_t ramps = 0;    // in the place of a jump, a beginning at once among them
};

// Curves run from 0 s to `duration_s`, which becomes a whole number of ticks, at least one gap.
FittedKnots fitted_knots(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                         double duration_s, const KnotRules& rules);

// "2 jumps become ramps of 20 ms", "37 points thinned to 16, at least 20 ms apart".
void remark_fit(const FittedKnots& fit, const KnotRules& rules, std::vector<std::string>& coarse);

}  // namespace tact
