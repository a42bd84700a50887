// The writers, one a format, and what they share.
#pragma once

#include "model/io/effects_out/write_effect.h"
#include "model/text/json_fields.h"

namespace tact {

WrittenEffect write_haptic(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_ahap(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_ahap_pair(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_hjif(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_android_xml(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_android_kotlin(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_android_timings(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_hla(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_pulsar(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_he(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_openxr(const Pattern& pattern, const EffectTarget& target);
WrittenEffect write_web(const Pattern& pattern, const EffectTarget& target);

// Whether it is flat between its jumps: then the steps of stepped() hold it.
bool is_staircase(const AmplitudeCurve& curve);

// "150 Hz left out: the device has its own frequency".
void remark_left_out_hz(const FrequencyCurve& curve, std::vector<std::string>& remarks);

// As text that ends with a line break.
std::string printed(const Json& document);

// Letters, digits and underscores, not a digit first: a name in source text.
std::string identifier(const std::string& name);

}  // namespace tact
