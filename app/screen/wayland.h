// Whether windows are shown by a Wayland compositor. Nobody is told there where a window is, and
// one that is covered is asked for no frame.
#pragma once

struct wl_display;

namespace tact {

// GLFW's connection to it. Null: windows are X11's, or GLFW is not in use.
wl_display* wayland_display();

}  // namespace tact
