// Presets of Pulsar (Software Mansion).
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

Likeness pulsar_likeness(const Json& document, std::string_view path);
Expected<Effects> read_pulsar(const Json& document, const EffectFile& file);
WrittenEffect write_pulsar(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kPulsarFormats{EffectFormat{.key = "pulsar",
                                                        .name = "Pulsar preset",
                                                        .map = "core-haptics",
                                                        .likeness = pulsar_likeness,
                                                        .read = read_pulsar}};

inline constexpr std::array kPulsarTargets{TargetTraits{.format = TargetFormat::pulsar,
                                                        .key = "pulsar",
                                                        .title = "Pulsar preset",
                                                        .ending = ".json",
                                                        .map = "core-haptics",
                                                        .write = write_pulsar}};

}  // namespace tact
