#include "app/live_code.h"

#include <algorithm>

namespace tact {

std::optional<LiveCode> compute_live_code(const LiveCodeRequest& request, std::stop_token stop,
                                          std::atomic<float>& progress) {
    const Waveform waveform = padded(waveform_of(request.vibration), request.samples);
    PredictOptions options;
    options.threads = 1;
    options.stop = stop;
    const auto codes = pattern_codes({&waveform, 1}, request.model, options);
    progress = 1.0F;
    if (codes.empty()) return std::nullopt;
    return LiveCode{request, codes[0],
                    predicted_brain_waveform(codes[0]->neural, request.model.channel_weight)};
}

std::size_t longest_samples(const PatternSet& set) {
    std::size_t longest = 0;
    for (const Vibration& vibration : set.vibrations) {
        if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
            longest = std::max(longest, sample_count(pattern->duration_s, kModelRateHz));
        } else {
            const auto& measurement = std::get<Measurement>(vibration.source);
            longest = std::max(longest, measurement.waveform->samples_g.size());
        }
    }
    return longest;
}

}  // namespace tact
