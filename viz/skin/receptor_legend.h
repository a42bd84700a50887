// The meaning of colours, halos and rings in maps of receptors, in one line for all maps.
#pragma once

#include "viz/drawing/theme.h"
#include "viz/skin/receptor_view.h"

namespace tact {

// The colour scale of all four types, from 0 to the rate of the strongest colour, and as much of
// the rest as fits.
void draw_receptor_legend(ImDrawList& list, const Theme& theme, const Rect& line,
                          double largest_hz);

}  // namespace tact
