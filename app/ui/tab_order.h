// Tab: from control to control, in reading order.
//
// ImGui's own Tab knows fields of text alone, and one window at a time. Here every noted item that
// can be pressed or typed in is a stop, over all panes, or within what lies over them. Ctrl+Tab
// goes on to the next pane, and who has clicked into a number or typed one to the next number.
// Enter presses what has the focus; arrows move within a list, whose rows are one stop.
//
// Left out  menus (Alt), and bars of fields that have an entry beside them.
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

// What the keys of this frame ask for, and what they are for.
struct TabOrder {
    std::vector<TabStop> stops;     // of this frame
    std::vector<unsigned> numbers;  // those of them that a number is typed in
    int step = 0;                   // 1: on, -1: back
    bool by_pane = false;
    bool is_on_button = false;  // Enter presses that, and nothing else
    bool has_begun = false;     // Tab goes on from what was used last; else from the first one
    unsigned over = 0;          // ImGui's name of what lies over the panes; 0: nothing
};

// The last ImGui item becomes a stop, if it can be one.
void note_stop(TabOrder& order);

// Ends a frame: the focus goes where Tab sent it, and is framed.
void move_focus(Ui& ui);

}  // namespace tact
