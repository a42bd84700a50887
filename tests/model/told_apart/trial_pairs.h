// Pairs to ask in tests: from PM 3 to 60, each farther than the one before by the same factor.
#pragma once

#include <cmath>
#include <string>

#include "model/told_apart/odd_trials.h"

namespace tact {

inline TrialDesign twelve_pairs(int trials, std::uint64_t seed) {
    TrialDesign design{trials, seed, {}};
    for (int k = 0; k < 12; ++k) {
        const std::string number = std::to_string(k + 1);
        design.pairs.push_back(
            {"one " + number, "other " + number, 3.0 * std::pow(20.0, k / 11.0)});
    }
    return design;
}

}  // namespace tact
