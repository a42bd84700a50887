// The calibration of the chosen device: kept with the choice, read when it is needed, and what a
// pattern is driven with.
//
// Left out  measuring: app/calibrate/measuring_response.h.
#pragma once

#include <filesystem>
#include <string>

#include "app/window/app.h"

namespace tact {

// Reads the file of the chosen device where another one is chosen; a fault is told once. What the
// rendering report takes a voice coil for follows it.
void follow_calibration(App& app);

void load_calibration_dialog(App& app);
void use_calibration(App& app, const std::filesystem::path& path);  // empty: none any more

// "Calibrated: coil, 2026-11-21, 20-500 Hz"; empty: it is not.
std::string calibration_text(const App& app);

// What makes the chosen device do `vibration`. By a calibration a minute of it takes a good part of
// a second: not for a thread that draws.
DriveRequest drive_request(const App& app, const Vibration& vibration);
MadeDrive made_drive(const DriveRequest& request);

}  // namespace tact
