// What the readers of effects say of a text, and a text for several of their tests.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "model/io/formats/read_effects.h"

namespace tact {

// An effect of Android: two control points of a waveform.
inline const std::string kEnvelopeXml =
    R"(<vibration-effect><waveform-envelope-effect initialFrequencyHz="20">
  <control-point amplitude="0.5" frequencyHz="80" durationMs="10"/>
  <control-point amplitude="0.25" frequencyHz="150" durationMs="30"/></waveform-envelope-effect></vibration-effect>)";

inline EffectsRead read(const std::string& text) {
    const auto effects = read_effects(text, "a.x");
    REQUIRE_MESSAGE(effects, (effects ? "" : effects.error().message));
    return *effects;
}

inline Effect only(const std::string& text) {
    const EffectsRead all = read(text);
    REQUIRE(all.effects.size() == 1);
    return all.effects.front();
}

inline std::string fault(const std::string& text) {
    const auto effects = read_effects(text, "a.x");
    return effects ? "" : effects.error().message;
}

inline bool has_remark(const Effect& effect, const std::string& words) {
    for (const std::string& remark : effect.remarks) {
        if (remark.find(words) != remark.npos) return true;
    }
    return false;
}

}  // namespace tact
