// The calibration of the chosen device: remembered with the device, read when needed, and used to
// make drives.
//
// Left out  measuring: app/calibrate/measuring_response.h.
#pragma once

#include <filesystem>
#include <string>

#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// Reads the calibration file when the chosen device changes, reports an error once, and sets the
// actuator of the rendering report to match.
void follow_calibration(Ui& ui, Workspace& work, RenderingState& rendered, PlayState& play);

// The file for measurements made in the window; empty: none.
std::filesystem::path calibration_folder(const Workspace& work);

// Opens the chooser in the folder of the calibration in use, or in the folder for measurements.
void load_calibration_dialog(Ui& ui, const Workspace& work, const PlayState& play);
void use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                     // empty: no calibration from now on
                     PlayState& play, const std::filesystem::path& path);

// "Calibrated: coil, 2026-11-21, 20-500 Hz"; empty if the device is not calibrated.
std::string calibration_text(const PlayState& play);

// The present settings of the window.
DrivenBy driven_by(const PlayState& play);

// The drive that makes the chosen device play `vibration`. With a calibration, one minute of it
// takes a good part of a second, so no thread that draws may call it.
DriveRequest drive_request(const PlayState& play, const Vibration& vibration);
MadeDrive made_drive(const DriveRequest& request);

}  // namespace tact
