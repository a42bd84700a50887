// A recording in the editor: gain, part and fades, and a pattern traced from it.
//
// Left out  several recordings at once: each has its own length.
#pragma once

#include "app/document/workspace.h"
#include "app/patterns/recording_state.h"
#include "app/ui/ui.h"

namespace tact {

// The selected part of the waveform, with its gain and fades. Samples are rounded to the 32 bits of
// its file.
Waveform cut(const Waveform& recording, const RecordingCut& how);

// "Cut from FILE: +3 dB, 0.2 to 1.4 s, fades of 10 and 20 ms."; empty if nothing was cut.
std::string cut_note(const RecordingCut& how, double length_s, const std::string& path);

// Draws nothing unless the current vibration is a recording.
void draw_recording_editor(Ui& ui, Workspace& work, RecordingEditor& editor);

}  // namespace tact
