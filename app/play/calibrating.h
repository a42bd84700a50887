// The calibration of the chosen device: kept with the choice, read when it is needed, and what a
// pattern is driven with.
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

// Reads the file of the chosen device where another one is chosen; a fault is told once. What the
// rendering report takes a voice coil for follows it.
void follow_calibration(Ui& ui, Workspace& work, RenderingState& rendered, PlayState& play);

// Where what is measured in the window is kept; empty: nowhere.
std::filesystem::path calibration_folder(const Workspace& work);

// In the folder of the one in use, else in that one.
void load_calibration_dialog(Ui& ui, const Workspace& work, const PlayState& play);
void use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                     PlayState& play, const std::filesystem::path& path);  // empty: none any more

// "Calibrated: coil, 2026-11-21, 20-500 Hz"; empty: it is not.
std::string calibration_text(const PlayState& play);

// As the window is set now.
DrivenBy driven_by(const PlayState& play);

// What makes the chosen device do `vibration`. By a calibration a minute of it takes a good part of
// a second: not for a thread that draws.
DriveRequest drive_request(const PlayState& play, const Vibration& vibration);
MadeDrive made_drive(const DriveRequest& request);

}  // namespace tact
