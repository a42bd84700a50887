#include "model/metrics/st_sim.h"
#include "model/common/portable.h"
#include "model/metrics/product_sum.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>

namespace tact {

namespace {

// Standard deviation below which a block is constant, as a share of its peak: rounding.
constexpr double kConstantShare = 1e-12;

double normal_distribution(double z) { return 0.5 * portable::erfc(-z / std::numbers::sqrt2); }

std::vector<double> z_normalised(std::span<const double> block) {
    std::vector<double> shape = without_mean(block);
    double peak = 0.0;
    for (const double sample : block) peak = std::max(peak, std::abs(sample));
    const double deviation =
        std::sqrt(product_sum(shape, shape) / static_cast<double>(block.size()));
    const bool is_constant = deviation <= kConstantShare * peak;
    for (double& value : shape) value = is_constant ? 0.0 : value / (deviation + kBlockEpsilon);
    return shape;
}

bool are_equal(const StSimBlocks& a, const StSimBlocks& b) {
    return a.support == b.support && a.shape == b.shape;
}

}  // namespace

StSimBlocks st_sim_blocks(const Waveform& waveform, const StSimParams& params) {
    const PerceptualBlocks blocks = perceptual_blocks(waveform, params.spectrum);
    StSimBlocks result;
    result.block_samples = blocks.block_samples;
    for (const double level_db : blocks.level_db) {
        result.support.push_back(normal_distribution(level_db / params.spread_db));
    }
    for (std::size_t b = 0; b < blocks.count; ++b) {
        const std::size_t begin = b * blocks.block_samples;
        const auto block = std::span(blocks.samples).subspan(begin, blocks.block_samples);
        const auto shape = z_normalised(block);
        const auto support = std::span(result.support).subspan(begin, blocks.block_samples);
        result.support_energy.push_back(product_sum(support, support));
        result.shape_energy.push_back(product_sum(shape, shape));
        result.shape.insert(result.shape.end(), shape.begin(), shape.end());
        result.is_silent.push_back(std::ranges::all_of(block, [](double x) { return x == 0.0; }));
    }
    return result;
}

StSim st_sim(const StSimBlocks& reference, const StSimBlocks& other, const StSimParams& params) {
    assert(reference.support.size() == other.support.size() && "patterns were not padded");
    if (are_equal(reference, other)) return {1.0, 1.0, 1.0};
    StSim result;
    std::size_t blocks = 0;
    for (std::size_t b = 0; b < reference.is_silent.size(); ++b) {
        const bool both_silent = reference.is_silent[b] && other.is_silent[b];
        if (both_silent && params.shared_silence == SharedSilence::left_out) continue;
        ++blocks;
        const auto block_of = [&](const std::vector<double>& values) {
            return std::span(values).subspan(b * reference.block_samples, reference.block_samples);
        };
        result.spectral += product_sum(block_of(reference.support), block_of(other.support)) /
                           (reference.support_energy[b] + kBlockEpsilon);
        result.temporal += product_sum(block_of(reference.shape), block_of(other.shape)) /
                           (reference.shape_energy[b] + kBlockEpsilon);
    }
    // Patterns that differ sound somewhere.
    assert(blocks > 0 && "two silences are equal");
    result.spectral /= static_cast<double>(blocks);
    result.temporal /= static_cast<double>(blocks);
    const bool is_clamped =
        params.negative_shape == NegativeShape::clamped && result.temporal < 0.0;
    if (is_clamped) result.temporal = 0.0;
    const double power = portable::pow(std::abs(result.temporal), params.shape_weight) *
                         portable::pow(result.spectral, 1.0 - params.shape_weight);
    result.similarity = std::copysign(power, result.temporal);
    return result;
}

}  // namespace tact
