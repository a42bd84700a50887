// A window whose program draws no more: it says "drawn" once it has the keys, never looks for
// events again, and ends well when Esc is heard all the same.
#include <GLFW/glfw3.h>

#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>

#include "app/screen/parts.h"
#include "tests/support/patience.h"

int main() {
    if (glfwInit() == GLFW_FALSE) return 1;
    GLFWwindow* const window = glfwCreateWindow(400, 300, "escape", nullptr, nullptr);
    if (window == nullptr) return 1;
    glfwMakeContextCurrent(window);
    std::mutex mutex;
    std::condition_variable changed;
    bool pressed = false;
    const tact::EscapeWatch watch(window, [&] {
        const std::lock_guard lock(mutex);
        pressed = true;
        changed.notify_one();
    });
    const auto until = tact::end_of_patience();
    while (glfwGetWindowAttrib(window, GLFW_FOCUSED) == GLFW_FALSE) {
        if (std::chrono::steady_clock::now() > until) return 1;
        glfwSwapBuffers(window);
        glfwWaitEventsTimeout(0.02);
    }
    std::cout << "drawn" << std::endl;
    std::unique_lock lock(mutex);
    return changed.wait_until(lock, until, [&] { return pressed; }) ? 0 : 1;
}
