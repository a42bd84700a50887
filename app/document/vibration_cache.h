// What panels draw of a vibration every frame, computed once per value.
//
// Left out  anything of the perceptual model: that comes from the jobs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "model/physiology/activation.h"
#include "model/set/pattern_set.h"

namespace tact {

struct CachedVibration {
    std::variant<Pattern, Measurement> source;
    Waveform waveform;  // of a pattern
    double peak_g = 0.0;
};

// By name; an entry is replaced when the vibration of that name has changed.
struct VibrationCache {
    std::unordered_map<std::string, CachedVibration> entries;

    // The spectrum of the one vibration that is shown large.
    std::variant<Pattern, Measurement> spectrum_source;
    NeuralCodingParams spectrum_params;
    std::vector<Component> components;
    bool has_components = false;

    // Small pictures may be behind by some frames, lest one frame renders all patterns of a set.
    std::size_t samples_left = std::numeric_limits<std::size_t>::max();  // to render in this frame
    bool behind = false;                                                 // some of them are

    // The strongest peak of the set: all waveforms are drawn on this one scale, in g.
    double reach_g = 1.0;
    std::uint64_t reach_of = 0;  // the revision it was found at, all its patterns rendered
};

const Waveform& cached_waveform(VibrationCache& cache, const Vibration& vibration);

// The same while there are samples left to render; then what it was before, or null.
const Waveform* waveform_in_time(VibrationCache& cache, const Vibration& vibration);

// Finds the scale of the set anew where its revision is another one, or peaks were not yet known:
// until a pattern is rendered it counts with what its numbers tell.
void follow_reach(VibrationCache& cache, const PatternSet& set, std::uint64_t revision);

const std::vector<Component>& cached_components(VibrationCache& cache, const Vibration& vibration,
                                                const NeuralCodingParams& params);

}  // namespace tact
