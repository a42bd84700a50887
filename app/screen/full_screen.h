// The window over the whole of the screen it is on, and back to where it was.
//
// Left out  several screens as one.
#pragma once

struct GLFWwindow;

namespace tact {

struct FullScreen {
    bool is_on = false;
    int x = 0;  // where the window goes back to
    int y = 0;
    int width = 0;
    int height = 0;
};

// Does nothing where it is so already, or where there is no screen to fill.
void set_full_screen(GLFWwindow& window, FullScreen& state, bool wanted);

}  // namespace tact
