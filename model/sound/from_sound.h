// A sound file as a named pattern, and all that is to be said of it: what the command and the
// window have in common.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/set/pattern_set.h"
#include "model/sound/sound_moved.h"
#include "model/sound/sound_pattern.h"

namespace tact {

// The actuator where nobody chooses.
inline constexpr const char* kUsualActuator = "core-haptics";

struct FromSoundOptions {
    ActuatorMap actuator = bundled_actuator(kUsualActuator);
    bool accents = true;
    // g that 1 of the sound stands for; default: the sidecar's, then the actuator's.
    std::optional<double> full_scale_g{};
    bool without_pm = false;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

struct FromSound {
    Vibration vibration;  // its name is the file's, its note what was done and lost
    SoundPattern made;
    double full_scale_g = 1.0;
    std::vector<std::string> remarks;  // on the file, then on what was lost: without their stop
    std::optional<SoundMoved> moved;   // none: not asked for
};

// Errors as read_sound_file, and where nothing of it lies in the band. PM is among the twelve
// patterns of Lim & Park 2023. Stopped: an Error that nobody needs to see.
Expected<FromSound> from_sound(const std::filesystem::path& path,
                               const FromSoundOptions& options = {});

}  // namespace tact
