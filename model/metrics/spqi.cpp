#include "model/metrics/spqi.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/common/portable.h"

namespace tact {

namespace {

constexpr double kLargestErrorDb = 60.0;

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

SpqiBlocks spqi_blocks(const Waveform& waveform, const SpqiParams& params) {
    const PerceptualBlocks blocks = perceptual_blocks(waveform, params.spectrum);
    SpqiBlocks result;
    result.block_samples = blocks.block_samples;
    result.block_power.assign(blocks.count, 0.0);
    for (std::size_t n = 0; n < blocks.level_db.size(); ++n) {
        result.power.push_back(portable::pow(10.0, blocks.level_db[n] / 10.0));
        result.block_power[n / blocks.block_samples] += result.power.back();
    }
    return result;
}

std::vector<double> spqi_errors_db(const SpqiBlocks& reference, const SpqiBlocks& other) {
    assert(reference.power.size() == other.power.size() && "patterns were not padded");
    std::vector<double> apart(reference.block_power.size(), 0.0);
    for (std::size_t n = 0; n < reference.power.size(); ++n) {
        apart[n / reference.block_samples] += std::abs(reference.power[n] - other.power[n]);
    }
    for (std::size_t b = 0; b < apart.size(); ++b) {
        apart[b] = 10.0 * portable::log10(apart[b] / (reference.block_power[b] + kBlockEpsilon));
    }
    return apart;
}

double spqi(const SpqiBlocks& reference, const SpqiBlocks& other, const SpqiParams& params) {
    std::vector<double> scores = spqi_errors_db(reference, other);
    for (double& score : scores) {
        // (1 - tanh z) / 2 in the form that keeps the digits of small scores.
        const double z = params.steepness_per_db * score - params.threshold;
        score = 1.0 / (1.0 + portable::exp(2.0 * z));
    }
    return mean(scores);
}

double spqi_distance(const SpqiBlocks& reference, const SpqiBlocks& other,
                     const SpqiParams& params) {
    if (params.distance == SpqiDistance::score) return 1.0 - spqi(reference, other, params);
    std::vector<double> errors_db = spqi_errors_db(reference, other);
    for (double& error_db : errors_db) {
        error_db = std::clamp(error_db, -kLargestErrorDb, kLargestErrorDb);
    }
    return kLargestErrorDb + mean(errors_db);
}

}  // namespace tact
