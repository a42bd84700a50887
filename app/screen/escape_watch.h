// Notices Esc in a window on X11 the moment it goes down, while the program's own thread may still
// be drawing.
//
// A connection of its own to the screen, which asks for the keys of that window as well: any number
// of clients may. GLFW hears of them, too, when it is asked the next time.
//
// Left out  Wayland, where a window's keys go to one connection: there GLFW's word comes first.
#pragma once

#include <functional>
#include <thread>

struct GLFWwindow;

namespace tact {

class EscapeWatch {
  public:
    // `pressed` is called on another thread, until this is destroyed. Without it, or where the
    // screen is not X11's, nothing is watched.
    EscapeWatch(GLFWwindow* window, std::function<void()> pressed);

  private:
    std::jthread thread_;
};

}  // namespace tact
