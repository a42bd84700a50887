// Actuator maps from files: Meta's actuator configurations (.acf, JSON5) and our own JSON.
//
//     {"actuator": "my phone", "source": "measured on ..", "frequency_hz": [80, 230],
//      "frequency_law": "linear", "intensity_law": "squared", "full_scale_g": 0.9,
//      "continuous_gain": 1, "transient_gain": 1, "fade_out": 0, "ducking": 1, "sensation_db": 40,
//      "burst_at_0": {"frequency_hz": 80, "duration_s": 0.03, "shape": "sine"}, "burst_at_1": {..}}
//
// Source    resources/acf of Meta's Haptics SDK (MIT); there emphasis_ducking multiplies the
//           continuous part: 1 leaves it as it is
// Output    errors as "FILE: PLACE: expected .."; missing keys of ours take ActuatorMap's defaults
// Left out  keys that neither knows.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"

namespace tact {

Expected<ActuatorMap> parse_actuator(std::string_view text, const std::string& file);
Expected<ActuatorMap> read_actuator_file(const std::filesystem::path& path);

// As our own JSON; reads back as the same map.
std::string print_actuator(const ActuatorMap& map);

}  // namespace tact
