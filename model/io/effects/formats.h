// The readers of effect files, one a format: a document whose format is known, as effects.
//
// Tolerant where the format's owner is, with a remark, and strict where the owner refuses. What
// each takes as published and what it guesses is at the head of its source file.
#pragma once

#include <string_view>

#include "model/io/effects/effect.h"

namespace tact {

Expected<Effects> read_ahap(const Json& document, const EffectFile& file);
Expected<Effects> read_haptic(const Json& document, const EffectFile& file);
Expected<Effects> read_hjif(const Json& document, const EffectFile& file);
Expected<Effects> read_haps(const Json& document, const EffectFile& file);
Expected<Effects> read_he(const Json& document, const EffectFile& file);
Expected<Effects> read_pulsar(const Json& document, const EffectFile& file);
Expected<Effects> read_timings(const Json& document, const EffectFile& file);  // Android, HLA
Expected<Effects> read_android_xml(std::string_view text, const EffectFile& file);

// Refuses times that are all below 1 ms, which were seconds; of no time but 0 there is no telling.
Expected<Done> times_make_sense(const EffectFile& file, double latest_ms);

}  // namespace tact
