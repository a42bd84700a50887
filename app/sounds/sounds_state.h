// What the window knows of sounds that are about to become patterns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/sound/from_sound.h"

namespace tact {

struct SoundsRequest {
    std::uint64_t document = 0;  // App::document_number that it was asked for
    std::vector<std::filesystem::path> files;
    std::string actuator = kUsualActuator;
    bool accents = true;
    double full_scale_g = 0.0;  // 0: the sidecar's, then the actuator's
    bool with_pm = false;       // takes longer: asked for once the rest is there

    bool operator==(const SoundsRequest&) const = default;
};

// A sound with the pattern made of it, or why it is missing.
struct SoundMade {
    std::string fault;
    std::optional<FromSound> sound;
    Waveform played;  // the pattern's
};

struct SoundsAnswer {
    SoundsRequest request;
    std::vector<SoundMade> sounds;  // as many as the request has files
};

struct SoundsState {
    SoundsRequest wanted;  // without PM
    std::size_t shown = 0;
    Query<SoundsRequest, SoundsAnswer> job;
    std::shared_ptr<const SoundsAnswer> answer;
};

}  // namespace tact
