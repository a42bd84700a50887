// Choosing a metric, and what is known of the comparison of all: shared by the tabs that show one.
#pragma once

#include <optional>
#include <vector>

#include "app/window/app.h"

namespace tact {

// A list to choose from; `with_people`: the ratings' own map too.
void draw_metric_choice(App& app, bool with_people);

// Progress, Cancel, or why there is no comparison; true where there is one to draw, perhaps of an
// earlier state.
bool draw_comparison_state(App& app);

// The pair that is chosen, as a scatter of `vibrations` has it: none where the open set has others.
std::optional<std::size_t> scatter_selection(const App& app,
                                             const std::vector<Vibration>& vibrations);

// Chooses the pair that was clicked there.
void choose_clicked(App& app, const std::vector<Vibration>& vibrations,
                    std::optional<std::size_t> clicked);

}  // namespace tact
