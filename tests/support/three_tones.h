// Patterns of pulses that are easily told apart, for twins of them.
#pragma once

#include <string>

#include "model/set/pattern_set.h"

namespace tact {

inline Vibration named_tone(const std::string& name, double frequency_hz) {
    Pattern pattern;
    pattern.carriers[0].frequency_hz = frequency_hz;
    pattern.rhythm = {"x=-x----", 0.05};
    pattern.duration_s = 0.4;
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

inline PatternSet three_tones() {
    PatternSet set;
    set.vibrations = {named_tone("pulse 1", 60.0), named_tone("pulse 12", 150.0),
                      named_tone("L-4/full", 250.0)};
    return set;
}

}  // namespace tact
