#include "app/screen/parts.h"

#include <dlfcn.h>

namespace tact {

// A GLFW that was built for X11 alone has no such function.
wl_display* wayland_display() {
    using Find = wl_display* (*)();
    const auto find = reinterpret_cast<Find>(::dlsym(RTLD_DEFAULT, "glfwGetWaylandDisplay"));
    return find == nullptr ? nullptr : find();
}

}  // namespace tact
