// The predicted brain waveform in whole units of its channel weights, and distances from it.
//
// Weights like 0.2, 0.7 and 0.5 are multiples of one unit u, so that a waveform is u times small
// whole numbers. With a and b these numbers,
//     N NC^2 = u^2 sum_n (a_n - b_n)^2 = u^2 (|a|^2 + |b|^2 - 2 a.b)
// one product a sample where spikes packed into bits take sixteen counts
// (model/physiology/nc_matrix.h).
//
// Source    Lim & Park 2023, section 4.3 (RMSE of the predicted brain waveforms).
// Valid     weights with about three decimals, of any common divisor; others have no such unit
// Exact     whole numbers up to the last root: the bits of nc_dissimilarity, on any processor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/physiology/neural_coding.h"

namespace tact {

// The weight of each channel in units.
struct WeightUnits {
    std::int64_t unit = 1;  // in units of the weights, see nc_matrix.h
    PerReceptor<std::int16_t> weight{};
    std::size_t summed = 0;  // number of products whose sum always fits into 32 bits
};

// Nullopt if no unit makes the weights small enough.
std::optional<WeightUnits> weight_units(const PerReceptor<double>& channel_weight);

struct BrainUnits {
    std::size_t samples = 0;
    std::vector<std::int16_t> values;  // up to the last spike, zero-padded to whole registers
    std::int64_t square = 0;           // sum of their squares
};

BrainUnits brain_units(const NeuralCode& code, const WeightUnits& units);

// Their NC. Both have one length.
double nc_dissimilarity(const BrainUnits& a, const BrainUnits& b, const WeightUnits& units);

// a.b over whole registers, as far as the shorter one reaches, for one instruction set; sums of
// `summed` products fit into 32 bits.
struct ProductSummer {
    const char* name;
    std::int64_t (*sum)(std::span<const std::int16_t> a, std::span<const std::int16_t> b,
                        std::size_t summed);
};

// Versions that this processor can run, the fastest first, which is in use.
std::span<const ProductSummer> product_summers();

}  // namespace tact
