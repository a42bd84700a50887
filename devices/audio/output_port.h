// An output that is open and asks for its sound by itself, on a thread of its library: what is left
// to be done with it. What uses a port cannot tell PortAudio's from a sound server's.
#pragma once

#include <chrono>
#include <functional>

namespace tact {

// The stream's time, which `heard_s` of render() is of, whoever asks for the sound.
inline double steady_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// What a library says between a frame's rendering and its being heard; what cannot be true counts
// as none.
inline double believable_s(double latency_s) {
    return latency_s >= 0.0 && latency_s < 2.0 ? latency_s : 0.0;
}

// From one thread at a time.
struct OutputPort {
    std::function<bool()> is_active;  // false: it has gone, or was cut
    std::function<void()> close;      // at once: what is on its way is not heard
    bool may_hang = true;             // it may wait for good for a server that was killed
};

}  // namespace tact
