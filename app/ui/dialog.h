// Begin and end of every dialog over the window.
#pragma once

#include <imgui.h>

#include "app/ui/ui.h"

namespace tact {

// The place of a dialog in the window.
enum class DialogSide {
    middle,
    right  // clear of the map, which the dialog is about
};

// Begins a dialog over the window. If true, everything up to begin_foot() scrolls when the window
// is too low for it, and one of the functions below must end the dialog.
bool begin_dialog(const Ui& ui, const char* title, float width_px = 620.0F,
                  DialogSide side = DialogSide::middle);

// Begins the part that always stays visible: buttons, and the values they apply to.
void begin_foot(const Ui& ui);

// Replaces ImGui::EndPopup(), after begin_foot().
void end_foot();

// Ends a dialog without an answer, before begin_foot(), because another one replaces it.
void give_way(Ui& ui);

// The largest height of the scrolling part, for a list in it that scrolls by itself.
float dialog_room_px();

// Presses the item with the focus of Tab, as Enter does: a button, a link, a choice; text fields
// take Enter themselves.
void press_focused(const Ui& ui);

// Style for the begin of a window that should look like a dialog.
ImFont* push_dialog_head(const Theme& theme);  // the previous font
void pop_dialog_head(ImFont* before);

// For any popup: a dialog, a menu, a list.
bool is_popup_open();

// Draws the frames of everything over the panes, at the end of a frame.
void draw_shadows(const Theme& theme);

// The last line of a dialog, with Close; Esc and Enter do the same.
void end_dialog(Ui& ui);

// The buttons at the end of a dialog. True if the person chose `action`, also with Enter; either
// button closes the dialog.
bool draw_ends(Ui& ui, const char* action, bool enabled);

}  // namespace tact
