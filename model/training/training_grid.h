// The combinations of the eight trained parameters, each that gives other predictions once.
//
// Only the order of NC counts, and of PM: weights in the same proportion are equal. So channel
// weights and the weights of NC and OC are kept as whole numbers without a common divisor, and how
// many combinations of the grid each of them stands for.
//
// Source    Lim & Park 2023, sections 4.3 and 5.3: L_E, L_I in 0..4, weights in 0..1 by 0.1:
//           25 x 11^4 x 121 = 44,289,025 combinations, of which 25 x 13,025 x 65 differ.
//           A model of which no channel has a weight is that of OC alone.
// Left out  what gives PM no order: both weights zero; NC alone, and no channel with a weight.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

inline constexpr int kMostTrainedLayers = 4;
inline constexpr std::size_t kTrainedLayers =
    std::size_t{kMostTrainedLayers + 1} * std::size_t{kMostTrainedLayers + 1};

using ChannelUnits = PerReceptor<int>;
struct MixUnits {
    int nc = 0;
    int oc = 0;
};

struct TrainingGrid {
    int units = 10;                      // a weight of 1; the paper's step is a tenth
    std::vector<ChannelUnits> channels;  // ascending
    std::vector<MixUnits> mixes;         // by share of NC; OC alone is the first, NC alone the last
    // How many combinations are in the same proportion.
    std::vector<std::uint32_t> channel_multiples;
    std::vector<std::uint32_t> mix_multiples;
};

TrainingGrid training_grid(int units);

// All combinations, those of no order included.
std::uint64_t combination_count(int units);

// L_E and L_I of a number below kTrainedLayers.
struct LayerCounts {
    int excitatory = 0;
    int inhibitory = 0;
};
constexpr LayerCounts layers_at(std::size_t index) {
    const int each = kMostTrainedLayers + 1;
    return {static_cast<int>(index) / each, static_cast<int>(index) % each};
}

// One class of equal combinations. kAny: this parameter does not matter, as OC alone decides.
inline constexpr std::uint32_t kAny = static_cast<std::uint32_t>(-1);
struct GridPoint {
    std::uint32_t layers = kAny;
    std::uint32_t channel = kAny;  // in TrainingGrid::channels
    std::uint32_t mix = 0;         // in TrainingGrid::mixes

    auto operator<=>(const GridPoint&) const = default;
};

// How many combinations of the grid it stands for.
std::uint64_t combinations_of(const TrainingGrid& grid, const GridPoint& point);

// `model` with the trained parameters of the point; of equal ones those nearest to the model's, in
// steps of the grid.
PerceptualModelParams nearest_model(const TrainingGrid& grid, const GridPoint& point,
                                    const PerceptualModelParams& model);

// How far the trained parameters of two models are apart: layers, and weights in steps of the grid.
double parameter_steps(const PerceptualModelParams& a, const PerceptualModelParams& b, int units);

}  // namespace tact
