// What every dialog over the window begins and ends with.
#pragma once

#include <imgui.h>

#include "app/ui/ui.h"

namespace tact {

// A dialog in the middle of the window; ImGui::EndPopup() where true.
bool begin_dialog(const Ui& ui, const char* title, float width_px = 620.0F);

// Of any kind: a dialog, a menu, a list.
bool is_popup_open();

// Of fields on the ground of dialogs and lists that open: the stock one is that ground, in the
// dark.
ImU32 dialog_field(const Theme& theme);

// Its last line, with Close; Esc and Enter do the same.
void end_dialog(Ui& ui);

// The buttons at its end and ImGui::EndPopup(). True when the dialog is to go on with `action`, on
// Enter too; either button closes it.
bool draw_ends(Ui& ui, const char* action, bool enabled);

}  // namespace tact
