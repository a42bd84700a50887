// Calibrating the chosen device in the window: the signal is played or written, the recording of an
// accelerometer read, and its table kept as the device's file.
//
// Left out  drawing: app/calibrate/calibrate_dialog.cpp. The measuring itself:
//           devices/calibration/calibration_run.h.
#pragma once

#include <filesystem>
#include <string>

#include "app/calibrate/calibrate_state.h"
#include "app/window/app.h"

namespace tact {

// The signal on the chosen device, whatever the level of the bar: its levels are shares of full
// scale. Stopped like any sound.
void play_calibration_signal(App& app);

// A WAV file of it.
void save_calibration_signal_dialog(App& app);
void save_calibration_signal(App& app, const std::filesystem::path& file);

// Choosing a recording, then the dialog again with what it says.
void open_calibration_recording_dialog(App& app);
void read_calibration_recording(App& app, const std::filesystem::path& file);

// After a change of what is played or how it is read. Each frame: what came of it, and the dialog
// again after files were chosen.
void look_at_recording(App& app);
void follow_calibrate(App& app);

// The answer to what was asked last; null: it is being computed, or nothing was asked.
const ResponseAnswer* current_answer(const CalibrateState& state);

// Writes the table to the file of this device and channel, and uses it.
void save_and_use_calibration(App& app);

}  // namespace tact
