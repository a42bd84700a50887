// From sound...: any sound becomes a pattern for an actuator, looked at before it is added.
//
// Input     files (model/io/recordings/sound_file.h), an actuator of the bundled ones
// Output    patterns in the set, one step of undo; a file that cannot be read is left out, said
// Left out  drawing: app/sounds/sounds_dialog.h
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/document/workspace.h"
#include "app/sounds/sounds_state.h"
#include "app/ui/ui.h"

namespace tact {

// Choosing a sound, then the dialog on it.
void from_sound_dialog(Ui& ui, const Workspace& work);
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
