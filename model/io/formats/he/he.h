// RichTap's .he and its sibling of OpenHarmony.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

Likeness he_likeness(const Json& document, std::string_view path);
Expected<Effects> read_he(const Json& document, const EffectFile& file);
WrittenEffect write_he(const Pattern& pattern, const EffectTarget& target);

inline constexpr std::array kHeFormats{EffectFormat{.key = "he",
                                                    .name = "RichTap or OpenHarmony .he",
                                                    .map = "richtap",
                                                    .ending = ".he",
                                                    .likeness = he_likeness,
                                                    .read = read_he}};

inline constexpr std::array kHeTargets{TargetTraits{.format = TargetFormat::he,
                                                    .key = "he",
                                                    .title = "RichTap .he",
                                                    .ending = ".he",
                                                    .map = "richtap",
                                                    .write = write_he}};

}  // namespace tact
