// A star plot: one ray per number, of that length, joined to an area; the first points up, the
// others follow clockwise.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <span>
#include <vector>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

// The end of a ray of length 1, from the middle.
ImVec2 star_ray(std::size_t ray, std::size_t rays);

// Corners of the area, in units of rays: a line for one number, for two a triangle with the centre.
std::vector<ImVec2> star_outline(std::span<const double> numbers);

// Draws numbers from 0 to 1 as an area, and the compared numbers as a thin line, in the largest
// square at the centre of `area`.
void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with);

}  // namespace tact
