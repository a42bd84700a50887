// On-off times in ms for navigator.vibrate, as a JSON array.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

inline constexpr const char* kVibrateEnding = ".vibrate.json";

Likeness vibrate_likeness(const Json& document, std::string_view path);
Expected<Effects> read_vibrate(const Json& document, const EffectFile& file);
WrittenEffect write_vibrate(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kVibrateFormats{EffectFormat{.key = "web",
                                                         .name = "web vibration",
                                                         .map = "phone-web",
                                                         .ending = kVibrateEnding,
                                                         .likeness = vibrate_likeness,
                                                         .read = read_vibrate}};

inline constexpr std::array kVibrateTargets{
    TargetTraits{.format = TargetFormat::web,
                 .key = "web",
                 .title = "Web vibration (phones' browsers)",
                 .ending = kVibrateEnding,
                 .map = "phone-web",
                 .write = write_vibrate}};

}  // namespace tact
