// A recording in the editor: gain, part and fades, and a pattern that is traced from it.
//
// Left out  several recordings at once: each has its own length.
#pragma once

#include "app/document/workspace.h"
#include "app/patterns/recording_state.h"
#include "app/ui/ui.h"

namespace tact {

// The part of the waveform with its gain, then the fades. Samples are rounded to what its file
// keeps (32 bits).
Waveform cut(const Waveform& recording, const RecordingCut& how);

// "Cut from FILE: +3 dB, 0.2 to 1.4 s, fades of 10 and 20 ms.": empty where nothing was.
std::string cut_note(const RecordingCut& how, double length_s, const std::string& path);

// Nothing where the current vibration is no recording.
void draw_recording_editor(Ui& ui, Workspace& work, RecordingEditor& editor);

}  // namespace tact
