// All stages of the one vibration that is shown large, computed in the background.
//
// It does not wait for the map: a very large set has no map, and a drag moves on before its
// exact one is there.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/physiology/stages.h"
#include "devices/calibration/rendering.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"
#include "model/set/pattern_set.h"
#include "model/textbook/textbook_beside.h"

namespace tact {

inline constexpr double kStepRateHz = kModelRateHz / static_cast<double>(kStepSamples);

struct LiveStagesRequest {
    Vibration vibration;
    std::size_t samples = 0;  // of the longest in its set: what it is padded to
    PerceptualModelParams model;
    std::optional<RenderedBy> rendered_by{};  // the vibration as a device plays it

    bool operator==(const LiveStagesRequest&) const = default;
};

LiveStagesRequest stages_request(const PatternSet& set, std::size_t index,
                                 const std::optional<RenderedBy>& rendered_by = {});

// One answer: a snapshot that panels draw as long as they like.
struct LiveStages {
    LiveStagesRequest request;
    Waveform waveform;          // padded, at 10 kHz
    NeuralCodingStages neural;  // without the layers, which are made for the step on screen
    PerReceptor<bool> only_leaks{};
    PerReceptor<Firing> firing{};
    PerReceptor<double> impulses_a_cycle{};
    PerReceptor<std::vector<char>> silent_steps;
    PerReceptor<SilentFiring> silent_firing{};
    std::array<std::vector<BesideFact>, kStages.size()> beside;  // of the textbook, by stage
    PerReceptor<std::vector<double>> population_hz;     // impulses/s of all receptors, per step
    PerReceptor<std::vector<double>> central_count;     // spikes per step
    PerReceptor<std::vector<double>> central_spikes;    // 0 or 1 per sample
    PerReceptor<std::vector<std::size_t>> by_distance;  // receptors, nearest first
    std::vector<double> brain_waveform;
    std::vector<double> envelope;
};

std::optional<LiveStages> compute_live_stages(const LiveStagesRequest& request,
                                              std::stop_token stop, std::atomic<float>& progress);

}  // namespace tact
