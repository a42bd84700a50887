// The calibration of the chosen device: kept with the choice, read when it is needed, and what a
// pattern is driven with.
//
// Left out  measuring: `tactspace calibrate` does it, as the sensor is recorded elsewhere.
#pragma once

#include <filesystem>
#include <string>

#include "app/app.h"

namespace tact {

// Reads the file of the chosen device where another one is chosen; a fault is told once.
void follow_calibration(App& app);

void load_calibration_dialog(App& app);
void use_calibration(App& app, const std::filesystem::path& path);  // empty: none any more

// "Calibrated: coil, 2026-11-21, 20-500 Hz"; empty: it is not.
std::string calibration_text(const App& app);

// What makes the chosen device do `vibration`, with a remark at the foot of the window where it
// cannot.
Drive drive_for(App& app, const Vibration& vibration);

}  // namespace tact
