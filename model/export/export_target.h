// What patterns are exported to: a format, and the actuator that its 0 to 1 are written for.
//
// As text "FORMAT" or "FORMAT:ACTUATOR": "ahap", "haptic:quest", "hjif:my phone.json".
#pragma once

#include <string>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/effects_out/write_effect.h"

namespace tact {

struct ExportTarget {
    TargetFormat format = TargetFormat::haptic;
    ActuatorMap map;

    bool operator==(const ExportTarget&) const = default;
};

// For the actuator that the format has where nobody chooses.
ExportTarget own_target(TargetFormat format);

// Errors say which formats there are, or what is wrong with the actuator.
Expected<ExportTarget> export_target_named(const std::string& text);
Expected<ExportTarget> export_target_named(const std::string& format, const std::string& actuator);

// "as AHAP for core-haptics holds them": what results of it are labelled with.
std::string words_on(const ExportTarget& target);

}  // namespace tact
