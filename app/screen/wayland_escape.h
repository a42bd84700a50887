// Esc in the windows of a Wayland client, noticed on a thread of its own:
// app/screen/escape_watch.h.
//
// Keys go to every keyboard that a client asked its seat for: a second one, with a queue of its
// own, hears of them while the first one's queue, GLFW's, waits for the drawing thread.
#pragma once

#include <functional>
#include <stop_token>

struct wl_display;

namespace tact {

// Until the stop, of which `woken` can be read, or until the compositor is gone. Where Esc is the
// key that most keyboards have it on: other layouts are GLFW's to read.
void watch_wayland_escape(const std::stop_token& stop, wl_display* display, int woken,
                          const std::function<void()>& pressed);

}  // namespace tact
