#include "app/screen/parts.h"

#include <X11/Xlib.h>
#include <unistd.h>
#include <wayland-client-core.h>

#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "devices/device/halt.h"

namespace tact {

namespace {

// Xlib's handlers are of the whole process and know no argument.
std::function<std::string()>
    keep_once;                   // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::thread::id drawing_thread;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

constexpr unsigned kLongestKeepingS = 20;

[[noreturn]] void end_telling(std::string_view what_is_kept) {
    const std::string sentence =
        "tactspace: the display is gone; " + std::string(what_is_kept) + "\n";
    [[maybe_unused]] const auto told = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    ::_exit(1);
}

int display_is_gone(Display* /*display*/) {
    rest_all();
    // The drawing thread hears of it as soon as it asks the screen for anything.
    if (std::this_thread::get_id() != drawing_thread) {
        ::sleep(kLongestKeepingS);
        end_telling("what was unsaved a second before may be kept for the next start");
    }
    const auto keep = std::exchange(keep_once, nullptr);
    const std::string fault =
        keep ? keep() : "they were being kept when the display went away again";
    end_telling(fault.empty() ? "unsaved changes are kept for the next start"
                              : "unsaved changes could not be kept: " + fault);
}

bool is_compositor_gone() {
    wl_display* const display = wayland_display();
    return display != nullptr && wl_display_get_error(display) != 0;
}

}  // namespace

void end_if_compositor_is_gone() {
    if (is_compositor_gone()) display_is_gone(nullptr);
}

void end_with_display(std::function<std::string()> keep) {
    drawing_thread = std::this_thread::get_id();
    keep_once = std::move(keep);
    XSetIOErrorHandler(keep_once ? display_is_gone : nullptr);
}

}  // namespace tact
