// Notices Esc in a window the moment it goes down, while the program's own thread may still be
// drawing.
//
// On X11 a connection of its own to the screen asks for the keys of that window as well: any number
// of clients may. On Wayland it is a keyboard of its own (app/screen/wayland_escape.h). GLFW hears
// of them, too, when it is asked the next time.
#pragma once

#include <functional>
#include <thread>

struct GLFWwindow;

namespace tact {

class EscapeWatch {
  public:
    // `pressed` is called on another thread, until this is destroyed. Without it nothing is
    // watched.
    EscapeWatch(GLFWwindow* window, std::function<void()> pressed);

  private:
    std::jthread thread_;
};

}  // namespace tact
