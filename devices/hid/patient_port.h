// A port that always comes back: what a write waits for is waited for on a thread of its own.
//
// A driver may keep a write for seconds, or for good. Whoever plays has to be able to stop, to say
// what is wrong and to end the program meanwhile.
//
// Left out  reading, which has its own time limit.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>

#include "devices/hid/hid_port.h"

namespace tact {

// Ranks this thread ahead of what draws and computes, where the system allows it to this program.
void rank_before_drawing();

// Longest time a packet may take: drivers have been seen to stall for three seconds and recover.
inline constexpr std::chrono::milliseconds kWritePatience{3500};

// ... and so long where the program is to end, or while an earlier one is still under way.
inline constexpr std::chrono::milliseconds kHurriedPatience{200};

// The same port, whose write() is false where the packet was not taken within `patience`, and while
// that one is still under way. The packet itself may be taken later. `hurries`: becomes true where
// nobody waits for the whole of it any more; null: never.
HidPort patient_port(HidPort port, std::chrono::milliseconds patience = kWritePatience,
                     std::shared_ptr<const std::atomic<bool>> hurries = nullptr);

}  // namespace tact
