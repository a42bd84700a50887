// What colours, halos and rings stand for in maps of receptors, on one line for all of them.
#pragma once

#include "viz/drawing/theme.h"
#include "viz/skin/receptor_view.h"

namespace tact {

// The ramp of all four types, from 0 to the rate of the strongest colour, and then as much of the
// rest as the line has room for.
void draw_receptor_legend(ImDrawList& list, const Theme& theme, const Rect& line,
                          double largest_hz);

}  // namespace tact
