// Places of the activated receptors of one type, and the number of impulses of each.
//
// Source    Lim & Park 2023, section 4.1 (Eq. 4) and 4.2 (sharing of impulses).
// Output    receptors on a square grid around the probe, row by row
// Valid     radii up to kFingertipMm: a few thousand receptors at most
// Left out  the irregularity of real receptor mosaics, the outline of the finger within that
//           radius.
#pragma once

#include <limits>
#include <vector>

#include "model/physiology/activation.h"

namespace tact {

struct GridReceptor {
    int column = 0;  // -half_width .. half_width
    int row = 0;
    double distance_mm = 0.0;
    double rate_hz = 0.0;  // its own mean rate, impulses/s
    double fires = 0.0;    // impulses over the whole signal, not rounded
};

struct ReceptorGrid {
    int half_width = 0;  // h; the grid is N0 x N0 with N0 = 2 h + 1
    double interval_mm = 1.0;
    std::size_t activated = 1;            // N, always at least the centre
    std::vector<GridReceptor> receptors;  // those within reach, row by row

    double x_mm(const GridReceptor& receptor) const { return receptor.column * interval_mm; }
    double y_mm(const GridReceptor& receptor) const { return receptor.row * interval_mm; }
};

// No limit.
inline constexpr int kWholeGrid = std::numeric_limits<int>::max();

// The receptors within r_max. Only those within L1 distance `reach` of the centre, in grid steps,
// are listed; all others still count in N and in the sharing.
ReceptorGrid receptor_grid(const Activation& activation, Receptor type, double duration_s,
                           FireSharing share, int reach = kWholeGrid);

}  // namespace tact
