#include "app/document/workspace.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "model/set/layers.h"

namespace tact {

namespace {

// No rendering is stronger, unless transients overlap.
double bound_g(const Pattern& pattern) {
    double sum = 0.0;
    for (const Carrier& carrier : pattern.carriers) sum += std::abs(carrier.weight);
    const bool am = pattern.modulation.kind == ModulationKind::am;
    double strongest_g = 0.0;
    for (const Transient& transient : pattern.transients) {
        strongest_g = std::max(strongest_g, transient.amplitude_g);
    }
    return pattern.amplitude_g * sum * (am ? 1.0 + pattern.modulation.depth : 1.0) + strongest_g;
}

double bound_g(const VibrationSource& source) {
    if (const auto* pattern = std::get_if<Pattern>(&source)) return bound_g(*pattern);
    const auto* layered = std::get_if<LayeredPattern>(&source);
    if (layered == nullptr) return 0.0;
    double sum_g = 0.0;
    for (std::size_t k = 0; k < layered->layers.size(); ++k) {
        const Layer& layer = layered->layers[k];
        if (!sounds(*layered, k)) continue;
        const auto* pattern = std::get_if<Pattern>(&layer.source);
        sum_g += layer.gain * (pattern != nullptr
                                   ? bound_g(*pattern)
                                   : peak_g(*std::get<Measurement>(layer.source).waveform));
    }
    return sum_g;
}

// None where the entry of the name is of another vibration.
std::optional<double> known_peak_g(const VibrationCache& cache, const Vibration& vibration) {
    const auto found = cache.entries.find(vibration.name);
    if (found == cache.entries.end()) return std::nullopt;
    const auto* measured = std::get_if<Measurement>(&vibration.source);
    const auto* kept = std::get_if<Measurement>(&found->second.source);
    // By address: to compare two recordings takes longer than to look for a peak.
    const bool same = measured != nullptr
                          ? kept != nullptr && kept->waveform == measured->waveform
                          : kept == nullptr && found->second.source == vibration.source;
    return same ? std::optional(found->second.peak_g) : std::nullopt;
}

// Not rendered yet: as it was, as much stronger as its numbers are. Else the scale of all would
// shake while the strongest is dragged.
double expected_peak_g(const VibrationCache& cache, const Vibration& vibration) {
    const double bound = bound_g(vibration.source);
    const auto found = cache.entries.find(vibration.name);
    if (found == cache.entries.end()) return bound;
    const double bound_before = bound_g(found->second.source);
    return bound_before > 0.0 ? found->second.peak_g * (bound / bound_before) : bound;
}

const Waveform& keep(VibrationCache& cache, const Vibration& vibration, Waveform waveform) {
    // Renamed and deleted patterns leave entries behind; clear all rather than keep them.
    constexpr std::size_t kMostEntries = 2000;
    if (cache.entries.size() > kMostEntries) cache.entries.clear();
    cache.reach_of = 0;
    const double peak = peak_g(waveform);
    return cache.entries
        .insert_or_assign(vibration.name,
                          CachedVibration{vibration.source, std::move(waveform), peak})
        .first->second.waveform;
}

bool is_long(const Vibration& vibration) {
    return own_duration_s(vibration) * kModelRateHz > static_cast<double>(kMostSamplesAtOnce);
}

std::optional<RenderedWaveforms> rendered_all(const WantedWaveforms& wanted, std::stop_token stop,
                                              std::atomic<float>& /*progress*/) {
    RenderedWaveforms rendered;
    for (const Vibration& vibration : wanted) {
        if (stop.stop_requested()) break;
        rendered.emplace_back(vibration, waveform_of(vibration));
    }
    return rendered;
}

}  // namespace

const Waveform& cached_waveform(VibrationCache& cache, const Vibration& vibration) {
    if (const auto* measurement = std::get_if<Measurement>(&vibration.source)) {
        return *measurement->waveform;
    }
    const auto found = cache.entries.find(vibration.name);
    if (found != cache.entries.end() && found->second.source == vibration.source) {
        return found->second.waveform;
    }
    return keep(cache, vibration, waveform_of(vibration));
}

void follow_render_job(VibrationCache& cache, const std::function<void()>& wake) {
    cache.has_job = wake != nullptr;
    if (auto rendered = cache.render_job.latest(); rendered && rendered != cache.taken) {
        for (const auto& [vibration, waveform] : *rendered) keep(cache, vibration, waveform);
        cache.taken = std::move(rendered);
        cache.asked.clear();  // what is wanted again later is asked for again
    }
    const WantedWaveforms wanted = std::exchange(cache.wanted, {});
    if (wanted.empty() || wanted == cache.asked) return;
    cache.asked = wanted;
    cache.render_job.ask(wanted, rendered_all, wake, JobPolicy::finish);
}

const Waveform* waveform_in_time(VibrationCache& cache, const Vibration& vibration) {
    if (std::holds_alternative<Measurement>(vibration.source)) {
        return &cached_waveform(cache, vibration);
    }
    const auto found = cache.entries.find(vibration.name);
    const bool known = found != cache.entries.end() && found->second.source == vibration.source;
    if (known) return &found->second.waveform;
    const bool beside = cache.has_job && is_long(vibration);
    if (beside) cache.wanted.push_back(vibration);
    if (beside || cache.samples_left == 0) {
        cache.behind = cache.behind || !beside;  // the job brings a frame when it is done
        return found == cache.entries.end() ? nullptr : &found->second.waveform;
    }
    const Waveform& fresh = cached_waveform(cache, vibration);
    cache.samples_left -= std::min(cache.samples_left, fresh.samples_g.size());
    return &fresh;
}

double peak_in_time(const VibrationCache& cache, const Vibration& vibration) {
    const auto found = cache.entries.find(vibration.name);
    return found == cache.entries.end() ? 0.0 : found->second.peak_g;
}

namespace {

// The longest, or six times the middle length where that is less: one long clip leaves the others
// to be seen.
double axis_of(const PatternSet& set) {
    constexpr double kMostOfMiddle = 6.0;
    std::vector<double> lengths;
    for (const Vibration& vibration : set.vibrations) lengths.push_back(own_duration_s(vibration));
    if (lengths.empty()) return 0.0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    return std::min(kMostOfMiddle * *middle, std::ranges::max(lengths));
}

}  // namespace

void follow_reach(VibrationCache& cache, const PatternSet& set, std::uint64_t revision) {
    if (cache.reach_of == revision) return;
    double reach_g = 0.0;
    for (const Vibration& vibration : set.vibrations) {
        auto peak = known_peak_g(cache, vibration);
        if (const auto* measured = std::get_if<Measurement>(&vibration.source); measured && !peak) {
            peak = peak_g(*measured->waveform);
            cache.entries.insert_or_assign(vibration.name,
                                           CachedVibration{vibration.source, {}, *peak});
        }
        reach_g = std::max(reach_g, peak ? *peak : expected_peak_g(cache, vibration));
    }
    cache.reach_g = reach_g > 0.0 ? reach_g : 1.0;
    cache.axis_s = axis_of(set);
    cache.reach_of = revision;
}

}  // namespace tact
