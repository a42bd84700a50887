#include "app/screen/display_loss.h"

#include <X11/Xlib.h>
#include <unistd.h>

#include <string_view>
#include <thread>
#include <utility>

namespace tact {

namespace {

// Xlib's handlers are of the whole process and know no argument.
std::function<void()> keep_once;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::thread::id drawing_thread;   // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

constexpr unsigned kLongestKeepingS = 20;

[[noreturn]] void end() {
    constexpr std::string_view kSentence =
        "tactspace: the display is gone; unsaved changes are kept for the next start\n";
    [[maybe_unused]] const auto told = ::write(STDERR_FILENO, kSentence.data(), kSentence.size());
    ::_exit(1);
}

int display_is_gone(Display* /*display*/) {
    // The drawing thread hears of it as soon as it asks the screen for anything.
    if (std::this_thread::get_id() != drawing_thread) {
        ::sleep(kLongestKeepingS);
        end();
    }
    if (const auto keep = std::exchange(keep_once, nullptr)) keep();
    end();
}

}  // namespace

void end_with_display(std::function<void()> keep) {
    drawing_thread = std::this_thread::get_id();
    keep_once = std::move(keep);
    XSetIOErrorHandler(keep_once ? display_is_gone : nullptr);
}

}  // namespace tact
