// A calibration as a file of its own, one for each device and channel.
//
//     {"tactspace_calibration": 1, "device": "...", "channel": 3, "actuator": "...",
//      "mounting": "...", "gain_note": "...", "sensor": "...", "date": "2026-11-21",
//      "load_mass_g": 12, "excursion_limit_mm": 0.8, "rms_limit": 0.4,
//      "points": [{"frequency_hz": 20, "g_per_full_scale": 0.9, "largest_drive": 0.6,
//                  "thd": 0.02, "nonlinearity": 0.01}]}
//
// A point that was not measured but worked out has "between": true as well.
//
// Input     missing fields take their defaults, but for the points; unknown ones are refused
// Output    errors name the file, the place and what was expected
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "devices/calibration/calibration.h"
#include "model/common/expected.h"

namespace tact {

Expected<Calibration> parse_calibration(std::string_view text, const std::string& file);
Expected<Calibration> read_calibration(const std::filesystem::path& path);

std::string print_calibration(const Calibration& calibration);
Expected<Done> write_calibration(const std::filesystem::path& path, const Calibration& calibration);

}  // namespace tact
