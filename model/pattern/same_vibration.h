// Whether two patterns are one vibration, however their parameters are written down.
//
// Carriers in another order or of no weight, a modulation of 0 Hz, a depth that the kind does not
// use, a rhythm written twice as long, a curve that is flat, transients in another order: none of
// them is heard, or felt.
//
// Output    numbers that are equal only where the patterns' samples at the model's rate are, but
// for
//           rounding in the twelfth digit
// Left out  vibrations that differ too little to be told apart; the few that are equal by laws of
//           sines (phases a whole turn apart, a sideband in the place of a carrier); curves
//           with points that a straight line needs not, or where nothing sounds.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

std::vector<double> essence(const Pattern& pattern);

// Patterns that were seen, each kept as a few bytes and made again to compare.
struct SeenVibrations {
    std::unordered_multimap<std::uint64_t, Pattern> by_digest;

    // False if an equal vibration was here before.
    bool add(const Pattern& pattern);
};

}  // namespace tact
