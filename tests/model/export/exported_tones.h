// Short patterns, and what their export costs.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/export/export_loss.h"

namespace tact {

inline Vibration tone(const std::string& name, double amplitude_g, double frequency_hz,
                      const std::string& rhythm = "") {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    if (!rhythm.empty()) pattern.rhythm = {rhythm, 0.02};
    pattern.duration_s = 0.12;
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

// Within what any target holds, but for jumps.
inline PatternSet six_tones() {
    PatternSet set;
    set.vibrations = {tone("a", 0.9, 80.0),         tone("b", 0.3, 80.0),
                      tone("c", 0.9, 200.0),        tone("d", 0.5, 140.0, "x-"),
                      tone("e", 0.7, 110.0, "x--"), tone("f", 0.4, 170.0, "x=-")};
    return set;
}

inline ExportLoss loss_of(const PatternSet& set, const ExportTarget& target,
                          ExportLossOptions options = {}) {
    auto loss = export_loss(set, target, options);
    REQUIRE(loss);
    return *std::move(loss);
}

inline bool contains(const std::vector<std::string>& remarks, const std::string& words) {
    return std::ranges::any_of(remarks,
                               [&](const std::string& one) { return one.find(words) != one.npos; });
}

}  // namespace tact
