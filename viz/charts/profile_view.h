// The best that each value of one parameter allows, all others being free: how sharply the data
// tell that parameter.
//
// Source    the profile of an objective (of a likelihood: Venzon & Moolgavkar 1988)
// Input     the best for each value of a grid; not finite: no combination with it has an order
// Output    the value under the mouse
// Left out  labels of values: the title says the chosen one, the read-out any other.
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
    Range shown{0.0, 1.0};                // of the objective, from the foot to the head
    std::size_t chosen = 0;               // places in `best`
    std::optional<std::size_t> before{};  // none: between the steps of the grid
    std::function<std::vector<std::string>(std::size_t)> readout{};
};

std::optional<std::size_t> draw_profile(const char* id, const Theme& theme, const Rect& area,
                                        const ProfileScene& scene);

// Where the best of a value is on the screen, kept within what is shown.
ImVec2 profile_point(const Theme& theme, const Rect& area, const ProfileScene& scene,
                     std::size_t place);

}  // namespace tact
