// The best result for each value of one parameter, with all others free: how sharply the data
// determine that parameter.
//
// Source    the profile of an objective (of a likelihood: Venzon & Moolgavkar 1988)
// Input     the best for each value of a grid; not finite: no combination with it has an order
// Output    the value under the mouse
// Left out  labels of values: the title has the chosen one, the read-out any other.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/range.h"
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

}  // namespace tact
