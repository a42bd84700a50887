// Sounds as patterns for an actuator, looked at before they are added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/sound/from_sound.h"

namespace tact {

// What the window knows of sounds that are about to become patterns.

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

// The dialog on sounds: for which actuator, what is heard beside what would be felt, what is lost.

inline constexpr Dialog kSoundsDialog{.title = "From sound", .is_of_document = true};
void draw_sounds_dialog(Ui& ui, Workspace& work, SoundsState& sounds);

// From sound...: any sound becomes a pattern for an actuator, looked at before it is added.
//
// Input     files (model/io/recordings/sound_file.h), an actuator of the bundled ones
// Output    patterns in the set, one step of undo; a file that cannot be read is left out, said

// Choosing a sound, then the dialog on it.
void from_sound_dialog(Ui& ui, const Workspace& work, SoundsState& sounds);
void open_sounds(Ui& ui, const Workspace& work, SoundsState& sounds,
                 const std::vector<std::filesystem::path>& files);

// Whether all of these are sounds by what they begin with, and none is a WAV file, which may be
// samples in g.
bool are_sounds(const std::vector<std::filesystem::path>& files);

// Asks for what is wanted; an older question is stopped.
void want_sounds(const Ui& ui, SoundsState& sounds);

// Takes what has come, and then asks for its PM.
void follow_sounds(const Ui& ui, SoundsState& sounds);

// The answer to what is wanted now, with PM or yet without; null while it is under way.
std::shared_ptr<const SoundsAnswer> current_sounds(const SoundsState& sounds);

std::size_t sounds_made(const SoundsAnswer& answer);  // of its files

// The patterns of an answer into the set; the first is selected.
void take_sounds(Ui& ui, Workspace& work, const SoundsAnswer& answer);

}  // namespace tact
