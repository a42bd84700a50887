// The most distinct patterns, those that are too close, and how sure that is.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_subset_panel(App& app);

}  // namespace tact
