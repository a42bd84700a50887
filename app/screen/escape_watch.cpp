#include "app/screen/parts.h"

#include <X11/Xlib.h>
#include <X11/keysym.h>
#include <dlfcn.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <stop_token>
#include <utility>

namespace tact {

namespace {

// GLFW has the function where it was built for X11; it is 0 for other windows.
Window x11_window(GLFWwindow* window) {
    using Find = Window (*)(GLFWwindow*);
    const auto find = reinterpret_cast<Find>(dlsym(RTLD_DEFAULT, "glfwGetX11Window"));
    return find == nullptr ? 0 : find(window);
}

bool is_escape(XEvent& event) {
    return event.type == KeyPress && XLookupKeysym(&event.xkey, 0) == XK_Escape;
}

// Until the stop, of which `woken` can be read.
void watch(const std::stop_token& stop, Display* display, int woken,
           const std::function<void()>& pressed) {
    std::array<pollfd, 2> sources{{{ConnectionNumber(display), POLLIN, 0}, {woken, POLLIN, 0}}};
    while (!stop.stop_requested()) {
        while (XPending(display) > 0) {
            XEvent event;
            XNextEvent(display, &event);
            if (is_escape(event)) pressed();
        }
        poll(sources.data(), sources.size(), -1);
    }
}

// `watch` runs on a thread of its own, and can wait for the file that tells of the stop.
using Watch = std::function<void(const std::stop_token&, int woken)>;

std::jthread start(Watch watch) {
    return std::jthread([watch = std::move(watch)](const std::stop_token& stop) {
        const int woken = eventfd(0, EFD_CLOEXEC);
        {
            const std::stop_callback wake(stop, [woken] { eventfd_write(woken, 1); });
            watch(stop, woken);
        }
        close(woken);
    });
}

std::jthread start_on_x11(GLFWwindow* window, std::function<void()> pressed) {
    const Window id = x11_window(window);
    if (id == 0) return {};
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return {};
    XSelectInput(display, id, KeyPressMask);
    XFlush(display);
    return start([display, pressed = std::move(pressed)](const std::stop_token& stop, int woken) {
        watch(stop, display, woken, pressed);
        XCloseDisplay(display);
    });
}

}  // namespace

EscapeWatch::EscapeWatch(GLFWwindow* window, std::function<void()> pressed) {
    if (!pressed) return;
    wl_display* const wayland = wayland_display();
    if (wayland == nullptr) {
        thread_ = start_on_x11(window, std::move(pressed));
        return;
    }
    thread_ =
        start([wayland, pressed = std::move(pressed)](const std::stop_token& stop, int woken) {
            watch_wayland_escape(stop, wayland, woken, pressed);
        });
}

}  // namespace tact
