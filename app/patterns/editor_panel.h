// The editor of the selected patterns.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_editor_panel(App& app);

}  // namespace tact
