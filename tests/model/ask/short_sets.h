// Short patterns that differ in all that questions to the map are about.
#pragma once

#include <cstddef>
#include <string>

#include "model/set/pattern_set.h"

namespace tact {

struct ShortSetSteps {
    double amplitude_g = 0.3;
    double carrier_hz = 40.0;
    double modulation_hz = 10.0;
    std::size_t modulations = 2;
};

inline PatternSet short_set(std::size_t count, const ShortSetSteps& step = {}) {
    PatternSet set;
    for (std::size_t k = 0; k < count; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.2;
        pattern.amplitude_g = 0.5 + step.amplitude_g * static_cast<double>(k % 3);
        pattern.carriers[0].frequency_hz = 50.0 + step.carrier_hz * static_cast<double>(k);
        pattern.modulation.frequency_hz =
            step.modulation_hz * static_cast<double>(k % step.modulations);
        Vibration vibration;
        vibration.name = "p" + std::to_string(k);
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace tact
