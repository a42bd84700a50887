// Dialogs over the window: files, keys, about.
#pragma once

#include "app/app.h"

namespace tact {

void draw_dialogs(App& app);

}  // namespace tact
