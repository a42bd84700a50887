// A library of many patterns as designers own them: ticks, buzzes and long effects, all different.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "model/common/random.h"
#include "model/set/pattern_set.h"

namespace tact {

// Lengths of .05 to 3 s, as many of each octave; the first lasts 3 s.
inline PatternSet mixed_set(std::size_t patterns) {
    RandomStream random{43};
    const auto share = [&random] { return 0.5 * (next_even(random) + 1.0); };
    PatternSet set;
    set.name = "mixed";
    set.duration_s = 3.0;
    for (std::size_t k = 0; k < patterns; ++k) {
        Pattern pattern;
        pattern.duration_s =
            k == 0 ? 3.0 : std::round(1e3 * 0.05 * portable::pow(60.0, share())) / 1e3;
        pattern.amplitude_g = 0.1 + 1.9 * share();
        pattern.carriers[0].frequency_hz = 30.0 + 270.0 * share();
        if (k % 3 == 0) pattern.carriers.push_back({60.0 + 300.0 * share(), 0.5 * share(), 0.0});
        if (k % 2 == 0) pattern.modulation.frequency_hz = 1.0 + 40.0 * share();
        if (k % 4 == 0) pattern.attack_s = 0.3 * pattern.duration_s * share();
        if (k % 5 == 0) pattern.transients.push_back({0.5 * pattern.duration_s * share(), 1.0});
        Vibration vibration;
        vibration.name = "pattern " + std::to_string(k);
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace tact
