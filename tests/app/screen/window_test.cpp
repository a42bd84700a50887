// The parts of the window that need no screen; the rest is tested with a real one (tests/e2e).
#include "app/screen/screen.h"

#include <doctest/doctest.h>

#include <cstdlib>

namespace window_test {

using namespace tact;

namespace {

// No screen within the scope.
struct NoDisplay {
    std::string before;
    bool was_set = false;

    NoDisplay() {
        if (const char* display = std::getenv("DISPLAY"); display != nullptr) {
            before = display;
            was_set = true;
        }
        unsetenv("DISPLAY");
    }
    ~NoDisplay() {
        if (was_set) setenv("DISPLAY", before.c_str(), 1);
    }
    NoDisplay(const NoDisplay&) = delete;
    NoDisplay& operator=(const NoDisplay&) = delete;
};

}  // namespace

TEST_CASE("window: without a display there is none, and the reason is said in words") {
    const NoDisplay none;
    CHECK_FALSE(display_available());
    int frames = 0;
    WindowClient client;
    client.frame = [&](const FrameContext&) {
        ++frames;
        return FrameRequest{};
    };
    const Expected<Done> answer = run_window({}, client);
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.starts_with("no display"));
    CHECK(answer.error().message.find("--help") != std::string::npos);
    CHECK(frames == 0);
}

TEST_CASE("window: waking one that is not there does nothing") {
    const NoDisplay none;
    wake_window();
    CHECK_FALSE(display_available());
    wake_window();
}

}  // namespace window_test
