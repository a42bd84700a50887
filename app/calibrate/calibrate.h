// Measuring an actuator.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/measured/measured.h"
#include "app/play/play.h"
#include "app/rendering/rendering.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "devices/calibration/calibration_run.h"

namespace tact {

// What the window knows of an actuator that is being measured: what is played, what was recorded,
// and what that says.

struct ResponseQuestion {
    std::uint64_t number = 0;
    CalibrationParams params;
    std::filesystem::path recording;
    AccelerationOptions options;
};

struct ResponseAnswer {
    ResponseQuestion question;
    std::vector<std::string> remarks;
    std::string fault;  // why there is no result
    CalibrationResult result;
};

struct CalibrateState {
    CalibrationParams params;
    std::filesystem::path recording;  // empty: none yet
    RecordingFields fields;
    Calibration about;  // all but the table
    bool is_playing = false;
    bool comes_back = false;  // the dialog, when a file is chosen or not
    std::uint64_t asked = 0;
    Query<ResponseQuestion, ResponseAnswer> job;
    std::shared_ptr<const ResponseAnswer> answer;  // of what was asked last, or before
};

// Over the window: calibrating the chosen device.

void draw_calibrate(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                    PlayState& play, CalibrateState& calibrating);

// Calibrating the chosen device in the window: the signal is played or written, the recording of an
// accelerometer read, and its table kept as the device's file.
//
// Left out  the measuring itself: devices/calibration/calibration_run.h

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
