// Interhaptics' .haps, which is read and not written.
#pragma once

#include <array>

#include "model/io/effects/effect_format.h"

namespace tact {

Likeness haps_likeness(const Json& document, std::string_view path);
Expected<Effects> read_haps(const Json& document, const EffectFile& file);

inline constexpr std::array kHapsFormats{EffectFormat{.key = "haps",
                                                      .name = "Interhaptics .haps",
                                                      .map = "interhaptics",
                                                      .ending = ".haps",
                                                      .likeness = haps_likeness,
                                                      .read = read_haps}};

}  // namespace tact
