// The patterns of a set as phones play them: on-off times.
//
// A phone's motor knows no g: the loudest of the set is full strength, and the others are in
// proportion to it, so that the set feels as one whatever phone it is felt on.
//
// Output    one pattern each, in the order of the set; a recording as well
// Exact     same set, same times.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

struct PhonePattern {
    std::string name;
    std::vector<int> ms;  // on, off, on, ..
    std::string loss;     // what of it is not felt, a sentence; empty: all is

    bool operator==(const PhonePattern&) const = default;
};

// How the patterns reached the skin, as a study's file and a measurement have it.
inline constexpr const char* kPhoneDevice = "phones (web vibration)";
inline constexpr const char* kPhoneStrength =
    "uncalibrated, on-off times alone: amplitude as the share of time that the motor runs";

struct PhonePatterns {
    std::vector<PhonePattern> patterns;
    double full_scale_g = 1.0;  // that counts as full strength: the loudest's peak; 1 for silence
};

// Nothing when stopped.
std::optional<PhonePatterns> phone_patterns(const PatternSet& set, std::stop_token stop = {});

}  // namespace tact
