// Patterns heard instead of felt: a preview on headphones, if no actuator is connected.
//
// All frequencies are two octaves higher, where the ear is as sensitive as the skin: 100 Hz sounds
// as 400 Hz. Strengths, rhythm and modulation are unchanged. The output is never saved as the
// device of an actuator, and the level starts as low as everywhere.
//
// Left out  recordings, which are heard unchanged, with a remark.
#pragma once

#include <optional>

#include "app/play/play_state.h"

namespace tact {

inline constexpr double kEarFactor = 4.0;
inline constexpr const char* kEarWords =
    "preview for the ear, two octaves up, not what the skin gets";

Pattern for_ear(Pattern pattern);
LayeredPattern for_ear(LayeredPattern layered);

// The system's default output; nullopt: it has none.
std::optional<DeviceInfo> ear_output(const PlayState& play);

}  // namespace tact
