// Dialogs over the window: files, keys, about, and those of every room.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_dialogs(App& app);

}  // namespace tact
