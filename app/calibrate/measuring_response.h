// Calibrating the chosen device in the window: the signal is played or written, the recording of an
// accelerometer read, and its table kept as the device's file.
//
// Left out  drawing: app/calibrate/calibrate_dialog.cpp. The measuring itself:
//           devices/calibration/calibration_run.h.
#pragma once

#include <filesystem>
#include <string>

#include "app/calibrate/calibrate_state.h"
#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// The signal on the chosen device, whatever the level of the bar: its levels are shares of full
// scale. Stopped like any sound.
void play_calibration_signal(Ui& ui, Timeline& timeline, PlayState& play,
                             CalibrateState& calibrating);

// A WAV file of it.
void save_calibration_signal_dialog(Ui& ui, const Workspace& work, CalibrateState& calibrating);
void save_calibration_signal(Ui& ui, const CalibrateState& calibrating,
                             const std::filesystem::path& file);

// Choosing a recording, then the dialog again with what it says.
void open_calibration_recording_dialog(Ui& ui, const Workspace& work, CalibrateState& calibrating);
void read_calibration_recording(const Ui& ui, CalibrateState& calibrating,
                                const std::filesystem::path& file);

// After a change of what is played or how it is read. Each frame: what came of it, and the dialog
// again after files were chosen.
void look_at_recording(const Ui& ui, CalibrateState& calibrating);
void follow_calibrate(Ui& ui, const PlayState& play, CalibrateState& calibrating);

// The answer to what was asked last; null: it is being computed, or nothing was asked.
const ResponseAnswer* current_answer(const CalibrateState& state);

// Writes the table to the file of this device and channel, and uses it.
void save_and_use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                              PlayState& play, const CalibrateState& calibrating);

}  // namespace tact
