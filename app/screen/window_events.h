// What the system tells of a window: keys and mouse on their way into the queue, files dropped, the
// wish to close, changes of its state.
//
// Input     GLFW's callbacks, on the thread that lets it deliver events
// Left out  whatever is read and not told: sizes, focus at the start of a frame.
#pragma once

#include <array>

#include "app/screen/input_queue.h"
#include "app/screen/window.h"

struct GLFWwindow;

namespace tact {

struct WindowEvents {
    const WindowClient* client = nullptr;  // told at once of what is more than input
    InputQueue input;
    std::array<int, key::kLast + 1> code_of_key{};  // what a held key meant when it went down
    unsigned buttons_held = 0;                      // one bit each
    bool fonts_outdated = true;                     // they are of another scale, or of none
    bool maximised = false;
    bool side_damaged = false;  // the screen has lost what was in the second window
};

// From now on, until the window is destroyed; `events` stays where it is, and is the window's user
// pointer.
void listen(GLFWwindow& window, WindowEvents& events);

// Keys of the second window count as pressed in the first.
void listen_to_keys(GLFWwindow& side, WindowEvents& events);

struct WindowSize {
    int width = 0;
    int height = 0;
};

WindowSize window_size(GLFWwindow* glfw);       // screen coordinates
WindowSize framebuffer_size(GLFWwindow* glfw);  // pixels

}  // namespace tact
