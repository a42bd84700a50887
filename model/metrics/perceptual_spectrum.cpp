#include "model/metrics/perceptual_spectrum.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"
#include "model/signal/resample.h"

namespace tact {

namespace {

constexpr double kCurvatureDb = 62.0;
constexpr double kCornerHz = 550.0;
constexpr double kOffset = 6.0 / 11.0;
constexpr double kKeenestDb = -77.0;

// cos(pi m / (2L)) for m = 0 .. 4L - 1, a whole turn: every cosine of a transform is among them.
std::vector<double> cosines(std::size_t block_samples) {
    std::vector<double> turn(4 * block_samples);
    for (std::size_t m = 0; m < turn.size(); ++m) {
        turn[m] = portable::cos(std::numbers::pi * static_cast<double>(m) /
                                static_cast<double>(2 * block_samples));
    }
    return turn;
}

// The sums as they stand: once a block, where pairs take the time.
std::vector<double> transformed(std::span<const double> block, const std::vector<double>& turn) {
    const auto samples = static_cast<double>(block.size());
    std::vector<double> lines(block.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
        double sum = 0.0;
        std::size_t angle = k;  // k (2n + 1) within the turn
        for (const double sample : block) {
            sum += sample * turn[angle];
            angle += 2 * k;
            if (angle >= turn.size()) angle -= turn.size();
        }
        lines[k] = std::sqrt((k == 0 ? 1.0 : 2.0) / samples) * sum;
    }
    return lines;
}

std::vector<double> prepared_samples(const Waveform& waveform,
                                     const PerceptualSpectrumParams& params) {
    std::vector<double> samples = params.rate == ThresholdRate::resampled_to_it
                                      ? resampled(waveform, kPublishedRateHz).samples_g
                                      : waveform.samples_g;
    if (params.unit == AmplitudeUnit::m_per_s2) {
        for (double& sample : samples) sample *= kStandardGravityMPerS2;
    }
    const std::size_t blocks = std::max<std::size_t>(1, samples.size() / params.block_samples);
    samples.resize(blocks * params.block_samples);
    return samples;
}

}  // namespace

std::vector<double> perceptual_threshold_db(std::size_t block_samples, double rate_hz) {
    const double corner = portable::log10(kOffset);
    std::vector<double> threshold(block_samples);
    for (std::size_t k = 0; k < block_samples; ++k) {
        if (k > 0 && threshold[k - 1] > 0.0) {
            threshold[k] = threshold[k - 1];
            continue;
        }
        const double f_hz =
            static_cast<double>(k) * rate_hz / static_cast<double>(2 * block_samples - 1);
        const double octaves = portable::log10(f_hz / kCornerHz + kOffset) / corner;
        threshold[k] = kCurvatureDb * octaves * octaves + kKeenestDb;
    }
    return threshold;
}

std::vector<double> cosine_transform(std::span<const double> block) {
    return transformed(block, cosines(block.size()));
}

PerceptualBlocks perceptual_blocks(const Waveform& waveform,
                                   const PerceptualSpectrumParams& params) {
    assert(params.block_samples > 0 && "a block has samples");
    PerceptualBlocks blocks;
    blocks.block_samples = params.block_samples;
    blocks.samples = prepared_samples(waveform, params);
    blocks.count = blocks.samples.size() / params.block_samples;
    const double rate_hz =
        params.rate == ThresholdRate::actual ? waveform.rate_hz : kPublishedRateHz;
    const auto threshold_db = perceptual_threshold_db(params.block_samples, rate_hz);
    const auto turn = cosines(params.block_samples);
    blocks.level_db.reserve(blocks.samples.size());
    for (std::size_t b = 0; b < blocks.count; ++b) {
        const auto block =
            std::span(blocks.samples).subspan(b * params.block_samples, params.block_samples);
        const auto lines = transformed(block, turn);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            blocks.level_db.push_back(20.0 * portable::log10(portable::abs(lines[k])) -
                                      threshold_db[k]);
        }
    }
    return blocks;
}

}  // namespace tact
