#include "app/screen/parts.h"

#include <epoxy/gl.h>
// After OpenGL's own header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>

namespace tact {

namespace {

constexpr int kSideWidth = 900;  // screen coordinates
constexpr int kSideHeight = 540;

std::span<GLFWmonitor*> screens() {
    int count = 0;
    GLFWmonitor** const all = glfwGetMonitors(&count);
    return {all, static_cast<std::size_t>(std::max(count, 0))};
}

struct ScreenArea {
    int x = 0;
    int y = 0;
    WindowSize size;
};

ScreenArea area_of(GLFWmonitor* screen) {
    ScreenArea area;
    glfwGetMonitorWorkarea(screen, &area.x, &area.y, &area.size.width, &area.size.height);
    return area;
}

// One that the middle of the program's window is not on. On Wayland no window knows where it is: it
// could be covered by what is as large as a screen.
std::optional<ScreenArea> other_screen(GLFWwindow& main) {
    if (wayland_display() != nullptr) return std::nullopt;
    int x = 0;
    int y = 0;
    glfwGetWindowPos(&main, &x, &y);
    const WindowSize size = window_size(&main);
    x += size.width / 2;
    y += size.height / 2;
    for (GLFWmonitor* screen : screens()) {
        const ScreenArea area = area_of(screen);
        const bool holds = x >= area.x && x < area.x + area.size.width && y >= area.y &&
                           y < area.y + area.size.height;
        if (!holds && area.size.width > 0) return area;
    }
    return std::nullopt;
}

void open_side(SideWindow& side, GLFWwindow& main, WindowEvents& events, const std::string& title) {
    const auto screen = other_screen(main);
    const WindowSize size = screen ? screen->size : WindowSize{kSideWidth, kSideHeight};
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);  // the clicker's keys stay where they are
    glfwWindowHint(GLFW_MAXIMIZED, screen ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "tactspace");
    side.glfw = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
    side.failed = side.glfw == nullptr;
    if (side.failed) return;
    if (screen) glfwSetWindowPos(side.glfw, screen->x, screen->y);
    listen_to_keys(*side.glfw, events);
    glfwMakeContextCurrent(side.glfw);
    glfwSwapInterval(0);  // the program's window waits for the screen already
    glfwShowWindow(side.glfw);
}

// Straight onto the screen, its first row on top.
void put_image(const Image& image) {
    unsigned texture = 0;
    unsigned framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, image.rgba.data());
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, image.width, image.height, 0, image.height, image.width, 0,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

float side_scale(GLFWwindow* glfw) {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(glfw, &x, &y);
    return std::max(x, y);
}

}  // namespace

std::function<void()> file_picker() { return {}; }

bool is_for_fingers() { return false; }

bool has_second_screen() { return screens().size() > 1; }

bool show_side(SideWindow& side, GLFWwindow& main, WindowEvents& events,
               const std::optional<SideContent>& content) {
    if (!content) {
        side.failed = false;
        close_side(side, main);
        return false;
    }
    if (side.glfw == nullptr && !side.failed) {
        open_side(side, main, events, content->title);
        glfwMakeContextCurrent(&main);
    }
    if (side.glfw == nullptr) return false;
    if (glfwWindowShouldClose(side.glfw) == GLFW_TRUE) {
        close_side(side, main);
        return true;
    }
    const WindowSize size = framebuffer_size(side.glfw);
    const bool same = side.shown == content->key && side.size.width == size.width &&
                      side.size.height == size.height;
    if (size.width > 0 && size.height > 0 && (!same || events.side_damaged)) {
        const Image image = content->draw(size.width, size.height, side_scale(side.glfw));
        glfwMakeContextCurrent(side.glfw);
        put_image(image);
        glfwSwapBuffers(side.glfw);
        side.shown = content->key;
        side.size = size;
        events.side_damaged = false;
        glfwMakeContextCurrent(&main);
    }
    return false;
}

void close_side(SideWindow& side, GLFWwindow& main) {
    if (side.glfw == nullptr) return;
    glfwDestroyWindow(side.glfw);
    const bool failed = side.failed;
    side = {};
    side.failed = failed;
    glfwMakeContextCurrent(&main);
}

}  // namespace tact
