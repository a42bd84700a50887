// Signals that ask the program to end - Ctrl+C, Ctrl+\, SIGTERM, a closed terminal - heard on a
// thread.
//
// The first one is handed on; the second ends the program as it would have been ended without a
// watch. One that was ignored when the program began (nohup, a shell's background job) stays
// ignored. Where a system has no signals, none is heard.
#pragma once

#include <functional>
#include <memory>

namespace tact {

// While it lives, those signals go to its thread. To be made before any other thread, as threads
// inherit the mask of signals.
class SignalWatch {
  public:
    // On its thread.
    using Heard = std::function<void(int signal)>;

    explicit SignalWatch(Heard heard);
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

  private:
    struct Works;
    std::unique_ptr<Works> works_;
};

}  // namespace tact
