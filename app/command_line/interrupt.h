// Ctrl+C, Ctrl+\, SIGTERM and a closed terminal as a request to stop, for work that has something
// to keep.
//
// The first one asks the work to stop and says so; the second ends the program at once. A signal
// that was ignored when the program began (nohup, a shell's background job) stays ignored.
#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace tact {

// While it lives, signals go to its thread. To be made before any other thread, as threads inherit
// the mask of signals.
class Interrupt {
  public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return stop_.get_token(); }

  private:
    void watch();

    sigset_t signals_{};
    sigset_t mask_before_{};
    std::stop_source stop_;
    std::stop_source end_;
    std::jthread watcher_;
};

// The exit code that shells expect of a program that was interrupted: 130 after Ctrl+C, 143 after
// SIGTERM, 129 after SIGHUP, 131 after SIGQUIT. 0: no Interrupt was asked to stop.
int interrupted_exit_code();

}  // namespace tact
