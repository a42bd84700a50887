// The list of patterns: search, order, names, locks.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_set_panel(App& app);

}  // namespace tact
