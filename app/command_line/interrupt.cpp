#include "app/command_line/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <cstdio>

namespace tact {

namespace {

// Signals are sent to the process, which has just one exit code.
std::atomic<int> caught{0};

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// As if nobody had been watching: a handler that silences a controller is left to do so.
void end_by(int signal) {
    sigset_t only_this;
    sigemptyset(&only_this);
    sigaddset(&only_this, signal);
    pthread_sigmask(SIG_UNBLOCK, &only_this, nullptr);
    std::raise(signal);
}

}  // namespace

Interrupt::Interrupt(Interrupted what) : what_(what) {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
        if (!is_ignored(signal)) sigaddset(&signals_, signal);
    }
    // To wake the watcher when all is done; sent to its thread alone.
    sigaddset(&signals_, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
    watcher_ = std::jthread([this] { watch(); });
}

Interrupt::~Interrupt() {
    end_.request_stop();
    pthread_kill(watcher_.native_handle(), SIGUSR2);
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void Interrupt::watch() {
    for (bool came_before = false;;) {
        int signal = 0;
        if (sigwait(&signals_, &signal) != 0) continue;
        if (signal == SIGUSR2 && end_.stop_requested()) return;
        if (signal == SIGUSR2) continue;
        if (came_before) end_by(signal);
        came_before = true;
        stop_by(signal);
    }
}

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
