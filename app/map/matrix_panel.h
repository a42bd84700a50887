// The dissimilarity of every pair.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_matrix_panel(App& app);

}  // namespace tact
