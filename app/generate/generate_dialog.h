// Over the window: which candidates to generate.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_generate_dialog(App& app);

}  // namespace tact
