#include "model/io/set/loaded.h"

#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

std::size_t recorded_samples(const Vibration& vibration) {
    std::size_t samples = 0;
    for (const Measurement* one : recordings_in(vibration)) {
        if (one->waveform != nullptr) samples += one->waveform->samples_g.size();
    }
    return samples;
}

std::size_t recorded_samples(const PatternSet& set) {
    std::size_t samples = 0;
    for (const Vibration& vibration : set.vibrations) samples += recorded_samples(vibration);
    return samples;
}

std::string samples_fault(std::size_t samples) {
    if (samples <= kMaxSetSamples) return {};
    return "expected at most " + grouped_digits(kMaxSetSamples) +
           " samples in all recordings, got more";
}

std::string counts_text(const Loaded& loaded) {
    if (loaded.left_out.empty()) return {};
    return grouped_digits(loaded.files) + (loaded.files == 1 ? " file" : " files") + " read, " +
           grouped_digits(loaded.left_out.size()) + " not";
}

}  // namespace tact
