// A star plot: a ray a number, as long as that is, joined to an area; the first points up, the
// others follow clockwise.
#pragma once

#include <imgui.h>

#include <span>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

// Of numbers from 0 to 1, and those they are compared with as a thin line; in the largest square
// in the middle of `area`. Of one number it is a line, of two a triangle with the middle.
void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with);

}  // namespace tact
