// Dialogs over the window: files, keys, about.
#pragma once

#include "app/app.h"

namespace tact {

void draw_dialogs(App& app);

// A dialog in the middle of the window; ImGui::EndPopup() where true.
bool begin_dialog(App& app, const char* title);

}  // namespace tact
