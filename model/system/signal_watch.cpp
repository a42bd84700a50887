#include "model/system/signal_watch.h"

#include <csignal>
#include <stop_token>
#include <thread>
#include <utility>

namespace tact {

namespace {

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

struct SignalWatch::Works {
    Heard heard;
    sigset_t signals{};
    sigset_t mask_before{};
    std::stop_source end{};
    std::jthread watcher{};

    explicit Works(Heard what) : heard(std::move(what)) {
        sigemptyset(&signals);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
            if (!is_ignored(signal)) sigaddset(&signals, signal);
        }
        // To wake the watcher when all is done; sent to its thread alone.
        sigaddset(&signals, SIGUSR2);
        pthread_sigmask(SIG_BLOCK, &signals, &mask_before);
        watcher = std::jthread([this] { watch(); });
    }

    void watch() {
        for (bool came_before = false;;) {
            int signal = 0;
            if (sigwait(&signals, &signal) != 0) continue;
            if (signal == SIGUSR2 && end.stop_requested()) return;
            if (signal == SIGUSR2) continue;
            if (came_before) end_by(signal);
            came_before = true;
            heard(signal);
        }
    }
};

SignalWatch::SignalWatch(Heard heard) : works_(std::make_unique<Works>(std::move(heard))) {}

SignalWatch::~SignalWatch() {
    works_->end.request_stop();
    pthread_kill(works_->watcher.native_handle(), SIGUSR2);
    works_->watcher.join();
    pthread_sigmask(SIG_SETMASK, &works_->mask_before, nullptr);
}

}  // namespace tact
