// What the model makes of the one vibration that is shown large, computed beside the window.
//
// It does not wait for the map: a very large set has no map, and a drag moves on before its
// exact one is there.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

#include "model/pattern_set.h"
#include "model/perceptual_model.h"

namespace tact {

struct LiveCodeRequest {
    Vibration vibration;
    std::size_t samples = 0;  // of the longest in its set: what it is padded to
    PerceptualModelParams model;

    bool operator==(const LiveCodeRequest&) const = default;
};

struct LiveCode {
    LiveCodeRequest request;
    std::shared_ptr<const PatternCode> code;
    std::vector<double> brain_waveform;
};

std::optional<LiveCode> compute_live_code(const LiveCodeRequest& request, std::stop_token stop,
                                          std::atomic<float>& progress);

}  // namespace tact
