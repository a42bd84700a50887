#include "app/screen/parts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>

namespace tact {
namespace {

static_assert(key::kEscape == GLFW_KEY_ESCAPE && key::kPageUp == GLFW_KEY_PAGE_UP);
static_assert(key::kEnd == GLFW_KEY_END && key::kKeypadEnter == GLFW_KEY_KP_ENTER);
static_assert(key::kF1 == GLFW_KEY_F1 && key::kRightSuper == GLFW_KEY_RIGHT_SUPER);
static_assert(key::kLast == GLFW_KEY_LAST);

WindowEvents& events_of(GLFWwindow* glfw) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(glfw));
}

void push_now(GLFWwindow* glfw, const decltype(InputEvent::what)& what) {
    push(events_of(glfw).input, {glfwGetTime(), what});
}

void on_key(GLFWwindow* glfw, int code, int scancode, int action, int) {
    KeyChange change;
    change.sign = sign_of(code, scancode);
    change.code = code_of(code, change.sign);
    change.down = action != GLFW_RELEASE;
    change.repeat = action == GLFW_REPEAT;
    if (code >= 0 && code <= GLFW_KEY_LAST) {
        // The layout may change while a key is down; it must be let go as what it was.
        int& held = events_of(glfw).code_of_key[static_cast<std::size_t>(code)];
        if (action == GLFW_PRESS) held = change.code;
        if (held != 0) change.code = held;
        if (action == GLFW_RELEASE) held = 0;
    }
    push_now(glfw, change);
    const WindowClient& client = *events_of(glfw).client;
    if (code == GLFW_KEY_ESCAPE && action == GLFW_PRESS && client.escape) client.escape();
}

// GLFW reports screen coordinates; where those are not pixels, the two sizes tell.
void on_move(GLFWwindow* glfw, double x, double y) {
    const WindowSize from = window_size(glfw);
    const WindowSize to = framebuffer_size(glfw);
    if (from.width <= 0 || from.height <= 0) return;
    push_now(glfw, MouseMove{static_cast<float>(x * to.width / from.width),
                             static_cast<float>(y * to.height / from.height)});
}

void on_button(GLFWwindow* glfw, int button, int action, int) {
    unsigned& held = events_of(glfw).buttons_held;
    const unsigned bit = 1U << static_cast<unsigned>(button);
    held = action == GLFW_PRESS ? held | bit : held & ~bit;
    push_now(glfw, MouseButton{button, action == GLFW_PRESS});
}

// A drag continues outside the window: a slider must not take "nowhere" for its low end.
void on_enter(GLFWwindow* glfw, int entered) {
    if (entered == GLFW_FALSE && events_of(glfw).buttons_held == 0) push_now(glfw, kMouseGone);
}

void on_drop(GLFWwindow* glfw, int count, const char** names) {
    const std::span all(names, static_cast<std::size_t>(std::max(count, 0)));
    const WindowClient& client = *events_of(glfw).client;
    if (client.drop) client.drop(std::vector<std::filesystem::path>(all.begin(), all.end()));
}

void on_close(GLFWwindow* glfw) {
    end_if_compositor_is_gone();
    const WindowClient& client = *events_of(glfw).client;
    if (client.close && !client.close()) glfwSetWindowShouldClose(glfw, GLFW_FALSE);
}

}  // namespace

void listen(GLFWwindow& window, WindowEvents& events) {
    GLFWwindow* glfw = &window;
    glfwSetWindowUserPointer(glfw, &events);
    glfwSetKeyCallback(glfw, on_key);
    glfwSetCharCallback(glfw, [](GLFWwindow* w, unsigned code) {
        push_now(w, Character{static_cast<char32_t>(code)});
    });
    glfwSetCursorPosCallback(glfw, on_move);
    glfwSetCursorEnterCallback(glfw, on_enter);
    glfwSetMouseButtonCallback(glfw, on_button);
    glfwSetScrollCallback(glfw, [](GLFWwindow* w, double x, double y) {
        push_now(w, MouseWheel{static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetWindowFocusCallback(
        glfw, [](GLFWwindow* w, int focused) { push_now(w, FocusChange{focused == GLFW_TRUE}); });
    glfwSetWindowContentScaleCallback(
        glfw, [](GLFWwindow* w, float, float) { events_of(w).fonts_outdated = true; });
    glfwSetWindowMaximizeCallback(glfw, [](GLFWwindow* w, int maximised) {
        events_of(w).maximised = maximised == GLFW_TRUE;
    });
    glfwSetDropCallback(glfw, on_drop);
    glfwSetWindowCloseCallback(glfw, on_close);
}

void listen_to_keys(GLFWwindow& side, WindowEvents& events) {
    glfwSetWindowUserPointer(&side, &events);
    glfwSetKeyCallback(&side, on_key);
    glfwSetWindowRefreshCallback(&side, [](GLFWwindow* w) { events_of(w).side_damaged = true; });
}

WindowSize window_size(GLFWwindow* glfw) {
    WindowSize size;
    glfwGetWindowSize(glfw, &size.width, &size.height);
    return size;
}

WindowSize framebuffer_size(GLFWwindow* glfw) {
    WindowSize size;
    glfwGetFramebufferSize(glfw, &size.width, &size.height);
    return size;
}

}  // namespace tact
