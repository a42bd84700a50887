// On-off times in ms for navigator.vibrate, as a JSON array.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

inline constexpr const char* kVibrateEnding = ".vibrate.json";

Likeness web_likeness(const Json& document, std::string_view path);
Expected<Effects> read_web(const Json& document, const EffectFile& file);
WrittenEffect write_web(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kWebFormats{EffectFormat{.key = "web",
                                                     .name = "web vibration",
                                                     .map = "phone-web",
                                                     .ending = kVibrateEnding,
                                                     .likeness = web_likeness,
                                                     .read = read_web}};

inline constexpr std::array kWebTargets{TargetTraits{.format = TargetFormat::web,
                                                     .key = "web",
                                                     .title = "Web vibration (phones' browsers)",
                                                     .ending = kVibrateEnding,
                                                     .map = "phone-web",
                                                     .write = write_web}};

}  // namespace tact
