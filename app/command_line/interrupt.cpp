#include "app/command_line/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>

namespace tact {

namespace {

// Signals are sent to the process, which has just one exit code.
std::atomic<int> caught{0};

}  // namespace

Interrupt::Interrupt(Interrupted what)
    : what_(what), watch_([this](int signal) { stop_by(signal); }) {}

void Interrupt::stop_by(int signal) {
    int none = 0;
    if (what_ == Interrupted::too_early) caught.compare_exchange_strong(none, signal);
    if (!stop_.request_stop() || is_silent_ || what_ == Interrupted::is_the_end) return;
    // Over what the progress line shows.
    std::fprintf(stderr, "%stactspace: stopping after the running work; once more stops at once\n",
                 isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "");
}

int interrupting_signal() { return caught; }

int interrupted_exit_code() {
    constexpr int kBySignal = 128;
    const int signal = interrupting_signal();
    return signal == 0 ? 0 : kBySignal + signal;
}

}  // namespace tact
