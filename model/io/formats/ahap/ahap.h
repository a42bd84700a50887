// Apple's haptic and audio patterns (AHAP), in one file or in two (ahap_pair.h).
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"
#include "model/io/formats/ahap/ahap_pair.h"

namespace tact {

Likeness ahap_likeness(const Json& document, std::string_view path);
Expected<Effects> read_ahap(const Json& document, const EffectFile& file);
std::string ahap_stranger(const std::filesystem::path& path, std::string_view head);
WrittenEffect write_ahap(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_ahap_pair(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kAhapFormats{EffectFormat{.key = "ahap",
                                                      .name = "AHAP",
                                                      .map = "core-haptics",
                                                      .ending = ".ahap",
                                                      .likeness = ahap_likeness,
                                                      .read = read_ahap,
                                                      .stranger = ahap_stranger}};

inline constexpr std::array kAhapTargets{
    TargetTraits{.format = TargetFormat::ahap,
                 .key = "ahap",
                 .title = "AHAP",
                 .ending = ".ahap",
                 .map = "core-haptics",
                 .write = write_ahap},
    // Two files: no control of one reaches the transients of the other.
    TargetTraits{.format = TargetFormat::ahap_pair,
                 .key = "ahap-pair",
                 .title = "AHAP in two files",
                 .ending = kContinuousEnding,
                 .beside = kTransientsEnding,
                 .map = "core-haptics",
                 .write = write_ahap_pair,
                 .join = joined_pair}};

}  // namespace tact
