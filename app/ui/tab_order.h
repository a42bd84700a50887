// Tab: from control to control, in reading order.
//
// ImGui's own Tab knows only text fields, and one window at a time. Here every noted item that can
// be pressed or typed in is a stop, over all panes, or within the topmost popup. Ctrl+Tab goes to
// the next pane; after a click into a number, or typing one, Tab goes to the next number. Enter
// presses the item with the focus; arrows move within a list, whose rows are one stop.
//
// Left out  menus (Alt), and sliders that have an entry beside them.
#pragma once

#include <vector>

struct ImGuiWindow;

namespace tact {

struct Ui;

struct TabStop {
    ImGuiWindow* window;
    unsigned id;
    float left, top, right, bottom;  // on the screen, px
    bool is_typed_in;
};

// Requests of this frame's keys, and the stops that they apply to.
struct TabOrder {
    std::vector<TabStop> stops;     // of this frame
    std::vector<unsigned> numbers;  // stops that are entries of numbers
    int step = 0;                   // 1: forward, -1: back
    bool by_pane = false;
    bool is_on_button = false;  // Enter presses that, and nothing else
    bool has_begun = false;     // Tab continues from the last used stop; false: from the first one
    unsigned over = 0;          // ImGui's id of the topmost popup; 0: none
};

// Makes the last ImGui item a stop, if it can be one.
void note_stop(TabOrder& order);

// Ends a frame: moves the focus, and draws its frame.
void move_focus(Ui& ui);

}  // namespace tact
