// Reading the golden tables, and comparisons that say by how much they failed.
#pragma once

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "tests/support/places.h"

namespace tact::golden {

using Json = nlohmann::json;

inline Json read(const std::string& file) {
    std::ifstream stream(std::string(kGoldenDir) + "/" + file);
    REQUIRE_MESSAGE(stream.good(), "golden file is missing: " << file);
    return Json::parse(stream);
}

// One part of it: a loop over a part of what read() returns would outlive the whole.
inline Json read(const std::string& file, const std::string& part) { return read(file).at(part); }

// Largest difference of two lists, as a share of the largest expected value.
inline double worst_difference(const std::vector<double>& got,
                               const std::vector<double>& expected) {
    REQUIRE(got.size() == expected.size());
    double scale = 1e-300;
    double worst = 0.0;
    for (const double value : expected) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < got.size(); ++k) {
        worst = std::max(worst, std::abs(got[k] - expected[k]));
    }
    return worst / scale;
}

// Rows of numbers, all of one length.
inline Eigen::MatrixXd matrix_of(const Json& rows) {
    Eigen::MatrixXd result(rows.size(), rows[0].size());
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
        for (Eigen::Index c = 0; c < result.cols(); ++c) {
            result(i, c) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)];
        }
    }
    return result;
}

inline std::vector<double> every(std::size_t stride, const std::vector<double>& values) {
    std::vector<double> result;
    for (std::size_t k = 0; k < values.size(); k += stride) result.push_back(values[k]);
    return result;
}

inline Pattern pattern_of(const Json& json) {
    Pattern pattern;
    pattern.amplitude_g = json.at("amplitude_g");
    pattern.carriers.clear();
    for (const Json& carrier : json.at("carriers")) {
        pattern.carriers.push_back(
            {carrier.at("frequency_hz"), carrier.at("weight"), carrier.at("phase_rad")});
    }
    const Json& modulation = json.at("modulation");
    pattern.modulation.kind =
        modulation.at("kind") == "am" ? ModulationKind::am : ModulationKind::product;
    pattern.modulation.frequency_hz = modulation.at("frequency_hz");
    pattern.modulation.depth = modulation.at("depth");
    pattern.rhythm = {json.at("rhythm").at("text"), json.at("rhythm").at("unit_s")};
    pattern.attack_s = json.at("attack_s");
    pattern.release_s = json.at("release_s");
    pattern.duration_s = json.at("duration_s");
    return pattern;
}

// White noise that any language makes to the bit: a linear congruential generator.
inline Waveform noise(std::uint32_t seed, std::size_t samples, double amplitude_g) {
    Waveform waveform;
    std::uint32_t state = seed;
    for (std::size_t n = 0; n < samples; ++n) {
        state = 1664525U * state + 1013904223U;
        waveform.samples_g.push_back(amplitude_g * (state / 2147483648.0 - 1.0));
    }
    return waveform;
}

inline Waveform waveform_of_case(const Json& json) {
    if (!json.contains("noise")) return render(pattern_of(json.at("pattern")));
    const Json& n = json.at("noise");
    return noise(n.at("seed"), n.at("samples"), n.at("amplitude_g"));
}

inline PerceptualModelParams params_of(const Json& json) {
    PerceptualModelParams params;
    if (json.value("share", "total") == "own") params.coding.share = FireSharing::own;
    if (json.value("components", "all") == "peaks") params.coding.components = Components::peaks;
    if (json.value("envelope", "normalised") == "raw") params.envelope.scale = EnvelopeScale::raw;
    params.coding.excitatory_layers = json.value("L_E", params.coding.excitatory_layers);
    params.coding.inhibitory_layers = json.value("L_I", params.coding.inhibitory_layers);
    if (json.contains("weights")) {
        for (const Receptor receptor : kReceptors) {
            params.channel_weight[index_of(receptor)] =
                json.at("weights").at(traits(receptor).afferent);
        }
    }
    return params;
}

}  // namespace tact::golden
