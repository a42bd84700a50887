#include "app/live_code.h"

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

}  // namespace tact
