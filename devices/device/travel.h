// How far an actuator moves over time: what a drive does together with what still moves from the
// ones before it.
//
// A mass on a spring that the drive's acceleration a(t) pushes:
//     x'' + sqrt(2) w x' + w^2 x = a(t),  w = 2 pi f0
// which integrates twice what is faster than f0 and comes to rest within a period of it. Two
// numbers, x and x', say all that is left of what came before, so that plays, loops, stops and
// changes add up exactly, at whatever phase.
//
// Source    the damped oscillator, stepped by its own solution; f0 is where a table's reach ends:
//           1/3 octave below its lowest point, where nothing is sent (devices/calibration)
// Input     acceleration in g at level 1, as a table makes it of a drive
// Exact     1 % at 3 f0 and above; 7 % less than a / w^2 at 1.6 f0, 15 % at 1.26 f0
// Left out  the actuator's own phase.
#pragma once

#include <span>
#include <vector>

namespace tact {

struct Motion {
    double x_mm = 0.0;
    double v_mm_s = 0.0;

    bool operator==(const Motion&) const = default;
};

// A drive's, at level 1. Nothing in `motions`: its limit is not known.
struct Travel {
    double limit_mm = 0.0;
    double f0_hz = 0.0;
    double step_s = 0.0;
    bool loop = false;            // its motion is that of its endless repetition
    std::vector<Motion> motions;  // at its start, and after each step

    bool operator==(const Travel&) const = default;
};

Travel travel_of(std::span<const double> acceleration_g, double rate_hz, double f0_hz,
                 double limit_mm, bool loop);

// Farthest from rest that a drive moves an actuator: from its start, over and over where it loops,
// and when it is stopped at any moment.
double most_travel_mm(const Travel& travel);

// So much later, with no drive.
Motion at_rest_after(Motion now, double f0_hz, double time_s);

// From `from_s` to `to_s` of a drive that was at `level` meanwhile.
Motion driven_on(Motion now, const Travel& travel, double from_s, double to_s, double level);

// The drive's own part of that motion. The parts of drives that play at once add up.
Motion driven_by(const Travel& travel, double from_s, double to_s, double level);

// The largest level at which a drive that continues at `from_s` moves nothing farther than its
// limit, together with the motion that is there; 2 % to spare, for rounding.
double level_within_travel(Motion now, const Travel& travel, double from_s);

}  // namespace tact
