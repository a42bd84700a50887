#include "app/document/vibration_cache.h"

#include <algorithm>

namespace tact {

const Waveform& cached_waveform(VibrationCache& cache, const Vibration& vibration) {
    if (const auto* measurement = std::get_if<Measurement>(&vibration.source)) {
        return *measurement->waveform;
    }
    // Renamed and deleted patterns leave entries behind; start anew rather than keep them all.
    constexpr std::size_t kMostEntries = 2000;
    if (cache.entries.size() > kMostEntries) cache.entries.clear();
    const auto found = cache.entries.find(vibration.name);
    if (found != cache.entries.end() && found->second.source == vibration.source) {
        return found->second.waveform;
    }
    CachedVibration fresh{vibration.source, waveform_of(vibration)};
    return cache.entries.insert_or_assign(vibration.name, std::move(fresh)).first->second.waveform;
}

const Waveform* waveform_in_time(VibrationCache& cache, const Vibration& vibration) {
    const auto found = cache.entries.find(vibration.name);
    const bool known = found != cache.entries.end() && found->second.source == vibration.source;
    if (known || std::holds_alternative<Measurement>(vibration.source)) {
        return &cached_waveform(cache, vibration);
    }
    if (cache.samples_left == 0) {
        cache.behind = true;
        return found == cache.entries.end() ? nullptr : &found->second.waveform;
    }
    const Waveform& fresh = cached_waveform(cache, vibration);
    cache.samples_left -= std::min(cache.samples_left, fresh.samples_g.size());
    return &fresh;
}

const std::vector<Component>& cached_components(VibrationCache& cache, const Vibration& vibration,
                                                const NeuralCodingParams& params) {
    const bool known = cache.has_components && cache.spectrum_source == vibration.source &&
                       cache.spectrum_params == params;
    if (known) return cache.components;
    const Waveform& waveform = cached_waveform(cache, vibration);
    const std::vector<double> input =
        params.remove_mean ? without_mean(waveform.samples_g) : waveform.samples_g;
    cache.components = components(amplitude_spectrum(input, waveform.rate_hz), params);
    cache.spectrum_source = vibration.source;
    cache.spectrum_params = params;
    cache.has_components = true;
    return cache.components;
}

}  // namespace tact
