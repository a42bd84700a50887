// The best result for each value of one parameter, with all others free: how sharply the data
// determine that parameter.
//
// Source    the profile of an objective (of a likelihood: Venzon & Moolgavkar 1988)
// Input     the best for each value of a grid; not finite: no combination with it has an order
// Output    the value under the mouse
// Left out  labels of values: the title has the chosen one, the read-out any other.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/units.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

struct ProfileScene {
    std::string_view title{};
    std::string_view detail{};  // dim, after the title
    std::span<const double> best{};
    Range shown{0.0, 1.0};                // range of the objective, from bottom to top
    std::size_t chosen = 0;               // index into `best`
    std::optional<std::size_t> before{};  // index of the previous choice; nullopt: between the
                                          // steps of the grid
    std::function<std::vector<std::string>(std::size_t)> readout{};
};

std::optional<std::size_t> draw_profile(const char* id, const Theme& theme, const Rect& area,
                                        const ProfileScene& scene);

// The place of a value's best on the screen, clamped to the shown range.
ImVec2 profile_point(const Theme& theme, const Rect& area, const ProfileScene& scene,
                     std::size_t place);

// A star plot: one ray per number, of that length, joined to an area; the first points up, the
// others follow clockwise.

// The end of a ray of length 1, from the middle.
ImVec2 star_ray(std::size_t ray, std::size_t rays);

// Corners of the area, in units of rays: a line for one number, for two a triangle with the centre.
std::vector<ImVec2> star_outline(std::span<const double> numbers);

// Draws numbers from 0 to 1 as an area, and the compared numbers as a thin line, in the largest
// square at the centre of `area`.
void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with);

}  // namespace tact
