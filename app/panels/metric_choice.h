// Choosing a metric, and what is known of the comparison of all: shared by the tabs that show one.
#pragma once

#include "app/app.h"

namespace tact {

// A list to choose from; `with_people`: the ratings' own map too.
void draw_metric_choice(App& app, bool with_people);

// Progress, Cancel, or why there is no comparison; true where there is one to draw, perhaps of an
// earlier state.
bool draw_comparison_state(App& app);

}  // namespace tact
