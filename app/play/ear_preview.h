// Patterns heard instead of felt, where no actuator is there: a preview on headphones.
//
// All frequencies are two octaves up, where the ear hears what the skin feels best: 100 Hz is
// 400 Hz. Strengths, rhythm and modulation are as they are. It is never remembered as the device of
// an actuator, and the level begins as low as everywhere.
//
// Left out  recordings, which are heard as they are, and say so.
#pragma once

#include <optional>

#include "app/play/play_state.h"

namespace tact {

inline constexpr double kEarFactor = 4.0;
inline constexpr const char* kEarWords =
    "preview for the ear, two octaves up, not what the skin gets";

Pattern for_ear(Pattern pattern);
LayeredPattern for_ear(LayeredPattern layered);

// The output that the system plays on by itself; none: there is none.
std::optional<DeviceInfo> ear_output(const PlayState& play);

}  // namespace tact
