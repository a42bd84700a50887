// An output that is open and asks for its sound by itself, on a thread of its library: what is left
// to be done with it. What uses a port cannot tell PortAudio's from a sound server's.
#pragma once

#include <functional>

namespace tact {

// From one thread at a time.
struct OutputPort {
    std::function<bool()> is_active;  // false: it has gone, or was cut
    std::function<double()> time_s;   // now, by the clock that `heard_s` of render() is of
    std::function<void()> close;      // at once: what is on its way is not heard
};

}  // namespace tact
