// Meta's .haptic, version 1.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

Likeness haptic_likeness(const Json& document, std::string_view path);
Expected<Effects> read_haptic(const Json& document, const EffectFile& file);
std::string haptic_stranger(const std::filesystem::path& path, std::string_view head);
WrittenEffect write_haptic(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kHapticFormats{EffectFormat{.key = "haptic",
                                                        .name = "Meta .haptic",
                                                        .map = "quest",
                                                        .ending = ".haptic",
                                                        .likeness = haptic_likeness,
                                                        .read = read_haptic,
                                                        .stranger = haptic_stranger}};

inline constexpr std::array kHapticTargets{TargetTraits{.format = TargetFormat::haptic,
                                                        .key = "haptic",
                                                        .title = "Meta .haptic",
                                                        .ending = ".haptic",
                                                        .map = "quest",
                                                        .write = write_haptic}};

}  // namespace tact
