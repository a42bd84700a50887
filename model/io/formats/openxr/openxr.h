// XR_EXT_haptic_parametric of OpenXR, as initialisers in C.
//
// Left out  reading initialisers that others wrote: their names and their order are not looked at.
#pragma once

#include <array>

#include "model/io/effects_out/written_effect.h"

namespace tact {

WrittenEffect write_openxr(const Pattern& pattern, const EffectTarget& target);

// Straight from minFrequencyHz to maxFrequencyHz, whatever law the map has.
Expected<Effect> openxr_back(const WrittenEffect& written, const EffectFile& file);

inline constexpr std::array kOpenxrTargets{TargetTraits{.format = TargetFormat::openxr,
                                                        .key = "openxr",
                                                        .title = "XR_EXT_haptic_parametric (C)",
                                                        .ending = ".c",
                                                        .map = "quest",
                                                        .write = write_openxr,
                                                        .read_back = openxr_back}};

}  // namespace tact
