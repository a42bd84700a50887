#include "app/screen/parts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tact {

namespace {

// The screen with the middle of the window; otherwise the main one, which may be null.
GLFWmonitor* screen_of(const FullScreen& at) {
    int count = 0;
    GLFWmonitor** const screens = glfwGetMonitors(&count);
    const int x = at.x + at.width / 2;
    const int y = at.y + at.height / 2;
    for (int k = 0; k < count; ++k) {
        int left = 0;
        int top = 0;
        glfwGetMonitorPos(screens[k], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(screens[k]);
        if (mode == nullptr) continue;
        const bool is_level = y >= top && y < top + mode->height;
        if (is_level && x >= left && x < left + mode->width) return screens[k];
    }
    return glfwGetPrimaryMonitor();
}

}  // namespace

void set_full_screen(GLFWwindow& window, FullScreen& state, bool wanted) {
    if (wanted == state.is_on) return;
    if (!wanted) {
        state.is_on = false;
        glfwSetWindowMonitor(&window, nullptr, state.x, state.y, state.width, state.height,
                             GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(&window, &state.x, &state.y);
    glfwGetWindowSize(&window, &state.width, &state.height);
    GLFWmonitor* const screen = screen_of(state);
    const GLFWvidmode* mode = screen == nullptr ? nullptr : glfwGetVideoMode(screen);
    if (mode == nullptr) return;
    state.is_on = true;
    glfwSetWindowMonitor(&window, screen, 0, 0, mode->width, mode->height, mode->refreshRate);
}

}  // namespace tact
