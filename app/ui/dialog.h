// What every dialog over the window begins and ends with.
#pragma once

#include <imgui.h>

#include "app/ui/ui.h"

namespace tact {

// Where a dialog stands in the window.
enum class DialogSide {
    middle,
    right  // clear of the map, which it is about
};

// A dialog over the window. Where true, what is drawn next scrolls if the window is too
// low for it, up to begin_foot(); and the dialog ends by one of the functions below.
bool begin_dialog(const Ui& ui, const char* title, float width_px = 620.0F,
                  DialogSide side = DialogSide::middle);

// What follows stays in sight: buttons, and what they are about.
void begin_foot(const Ui& ui);

// In the place of ImGui::EndPopup(), after begin_foot().
void end_foot();

// The dialog ends without an answer, in the middle of what scrolls, for what comes in its place.
void give_way(Ui& ui);

// How high what scrolls may be, for a part of it that scrolls by itself.
float dialog_room_px();

// As Enter does, of what Tab has led to: a button, a link, a choice; not a field of text.
void press_focused(const Ui& ui);

// Around what begins a window that looks like one.
ImFont* push_dialog_head(const Theme& theme);  // the font before
void pop_dialog_head(ImFont* before);

// Of any kind: a dialog, a menu, a list.
bool is_popup_open();

// Around all that lies over the panes: at the end of a frame.
void draw_shadows(const Theme& theme);

// Its last line, with Close; Esc and Enter do the same.
void end_dialog(Ui& ui);

// The buttons at its end. True when the dialog is to go on with `action`, on
// Enter too; either button closes it.
bool draw_ends(Ui& ui, const char* action, bool enabled);

}  // namespace tact
