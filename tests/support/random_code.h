// Neural codes of no pattern at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "model/physiology/neural_coding.h"

namespace tact {

// Spikes at random: each channel at every fourth sample, in every combination.
inline NeuralCode random_code(std::size_t samples, std::uint32_t seed) {
    std::mt19937 random(seed);
    NeuralCode code;
    code.samples = samples;
    for (std::size_t n = 0; n < samples; ++n) {
        code.central_spikes.push_back(static_cast<std::uint8_t>(random() & random() & 15U));
    }
    return code;
}

}  // namespace tact
