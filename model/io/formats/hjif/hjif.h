// MPEG's haptic interchange format (HJIF, ISO/IEC 23090-31).
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"
#include "model/io/effects_out/written_effect.h"

namespace tact {

Likeness hjif_likeness(const Json& document, std::string_view path);
Expected<Effects> read_hjif(const Json& document, const EffectFile& file);
WrittenEffect write_hjif(const Pattern& pattern, const EffectTarget& target);
// Patterns that sound at once are bands.
WrittenEffect write_hjif_bands(std::span<const Pattern> patterns, const EffectTarget& target);

inline constexpr std::array kHjifFormats{EffectFormat{.key = "hjif",
                                                      .name = "MPEG HJIF",
                                                      .map = "mpeg",
                                                      .ending = ".hjif",
                                                      .likeness = hjif_likeness,
                                                      .read = read_hjif}};

inline constexpr std::array kHjifTargets{TargetTraits{.format = TargetFormat::hjif,
                                                      .key = "hjif",
                                                      .title = "MPEG HJIF",
                                                      .ending = ".hjif",
                                                      .map = "mpeg",
                                                      .write = write_hjif,
                                                      .write_at_once = write_hjif_bands}};

}  // namespace tact
