// What patterns are exported to: a format, and the actuator that its 0 to 1 are written for; of
// samples, which are in g, their rate and encoding instead.
//
// As text "FORMAT" or "FORMAT:ACTUATOR": "ahap", "haptic:quest", "hjif:my phone.json", "wav".
#pragma once

#include <string>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/formats/write_effect.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ExportTarget {
    TargetFormat format = TargetFormat::haptic;
    ActuatorMap map{};  // of a format that is not sampled
    SampledAs sampled{};

    bool operator==(const ExportTarget&) const = default;
};

// For the actuator that the format has where nobody chooses.
ExportTarget own_target(TargetFormat format);

// For the actuator that somebody chose as the set's effects were read: all by one map, which is not
// their formats' own, and which the program knows by its name. Else as own_target.
ExportTarget usual_target(TargetFormat format, const PatternSet& set);

// Errors say which formats there are, or what is wrong with the actuator.
Expected<ExportTarget> export_target_named(const std::string& text);
Expected<ExportTarget> export_target_named(const std::string& format, const std::string& actuator);

// "as AHAP for core-haptics holds them", "as WAV of 48,000 Hz and 24 bits holds them": what results
// of it are labelled with.
std::string words_on(const ExportTarget& target);

// "actuator quest: Hz, bursts ..", "1.6 g at full scale, which ..": what its numbers mean, and
// which of that is guessed.
std::string meaning_of(const ExportTarget& target);

}  // namespace tact
