// What every dialog over the window begins and ends with.
#pragma once

#include <imgui.h>

#include "app/ui/ui.h"

namespace tact {

// A dialog in the middle of the window; ImGui::EndPopup() where true.
bool begin_dialog(const Ui& ui, const char* title, float width_px = 620.0F);

// Around what begins a window that looks like one.
ImFont* push_dialog_head(const Theme& theme);  // the font before
void pop_dialog_head(ImFont* before);

// Of any kind: a dialog, a menu, a list.
bool is_popup_open();

// Around all that lies over the panes: at the end of a frame.
void draw_shadows(const Theme& theme);

// Its last line, with Close; Esc and Enter do the same.
void end_dialog(Ui& ui);

// The buttons at its end and ImGui::EndPopup(). True when the dialog is to go on with `action`, on
// Enter too; either button closes it.
bool draw_ends(Ui& ui, const char* action, bool enabled);

}  // namespace tact
