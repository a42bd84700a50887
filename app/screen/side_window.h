// A second window beside the program's: a picture that is shown where those who look at the first
// one do not see it.
//
// Input     what is to be in it, as a picture to be drawn for its size; keys pressed in it are the
//           program's
// Output    on another screen, where there is one: over the whole of it; else, and on Wayland, a
//           window of its own
// Left out  the mouse
#pragma once

#include <optional>
#include <string>

#include "app/screen/window_events.h"

struct GLFWwindow;

namespace tact {

struct SideWindow {
    GLFWwindow* glfw = nullptr;  // null: no window
    std::string shown;           // the key of what is in it
    WindowSize size;             // of what is in it, pixels
    bool failed = false;         // the system gave none: it is not asked again
};

// After a frame of the program's window, whose context is current again afterwards. True, once,
// when the person has closed it.
bool show_side(SideWindow& side, GLFWwindow& main, WindowEvents& events,
               const std::optional<SideContent>& content);

void close_side(SideWindow& side, GLFWwindow& main);

}  // namespace tact
