// Whether sound was missing at an output whose library does not tell: what was rendered lasts for
// so long, and it is asked for more later than that.
//
// Nothing here goes by a latency that is reported: that changes by itself, as when a recorder comes
// to the same output.
//
// Left out  the first time that the output takes to start, which looks like a gap.
#pragma once

#include <algorithm>
#include <limits>

namespace tact {

// The account of one stream since its first call. It asks the system for nothing, so that a
// callback may keep it.
struct Supply {
    double lasts_s = 0.0;  // what the output keeps, at most
    double rendered_s = 0.0;
    double earliest_s =
        std::numeric_limits<double>::infinity();  // of the clock less what was rendered
};

// A clock of the output that is off by less than this, which is far beyond any, makes no gaps.
inline constexpr double kMostDrift = 1e-3;

// So much more is asked for at `now_s`. True: what was rendered before did not last until then.
inline bool has_run_dry(Supply& supply, double now_s, double seconds) {
    const double behind_s = now_s - supply.rendered_s;
    supply.earliest_s = std::min(supply.earliest_s, behind_s);
    const bool is_dry = behind_s - supply.earliest_s > supply.lasts_s;
    if (is_dry) supply.earliest_s = behind_s - supply.lasts_s;
    supply.earliest_s += kMostDrift * seconds;
    supply.rendered_s += seconds;
    return is_dry;
}

}  // namespace tact
