// Numbers typed into the entries of the program.
#pragma once

#include <string>

#include "tests/support/program.h"

namespace tact {

// 1 s: bins of 1 Hz, as most sets have.
inline PatternSet odd_numbers(std::size_t count) {
    PatternSet set = short_patterns(count);
    set.duration_s = 1.0;
    for (Vibration& vibration : set.vibrations) {
        auto& pattern = std::get<Pattern>(vibration.source);
        pattern.duration_s = 1.0;
        pattern.amplitude_g = 1.5;
        pattern.carriers[0].frequency_hz = 180.0;
        pattern.modulation.frequency_hz = 2.5;
    }
    return set;
}

inline void enter(Program& program, const std::string& entry, const std::string& text) {
    program.click(entry);
    program.type(text);
    program.press_key(key::kEnter);
}

}  // namespace tact
