// What panels draw of a vibration every frame, computed once per value.
//
// Left out  anything of the perceptual model: that comes from the jobs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "app/jobs/query.h"
#include "model/set/pattern_set.h"

namespace tact {

struct CachedVibration {
    VibrationSource source;
    Waveform waveform;  // of a pattern, or of layers
    double peak_g = 0.0;
};

// Long patterns that a frame wanted, rendered in the background.
using WantedWaveforms = std::vector<Vibration>;
using RenderedWaveforms = std::vector<std::pair<Vibration, Waveform>>;

// By name; an entry is replaced when the vibration of that name has changed.
struct VibrationCache {
    std::unordered_map<std::string, CachedVibration> entries;

    // Small pictures may be behind by some frames, so that no frame renders all patterns of a set.
    std::size_t samples_left = std::numeric_limits<std::size_t>::max();  // to render in this frame
    bool behind = false;                                                 // some of them are
    bool put_off = false;  // all of them, in this frame: it has others to draw

    bool has_job = false;  // for long ones, which are otherwise, as for a picture, rendered at once
    Query<WantedWaveforms, RenderedWaveforms> render_job;
    WantedWaveforms wanted, asked;
    std::shared_ptr<const RenderedWaveforms> taken;

    // The strongest peak of the set: all waveforms are drawn on this one scale, in g.
    double reach_g = 1.0;
    double axis_s = 0.0;         // the end of the time axis that pictures of the set share
    std::uint64_t reach_of = 0;  // the revision it was found at, all its patterns rendered
};

const Waveform& cached_waveform(VibrationCache& cache, const Vibration& vibration);

// Above this many samples a pattern is rendered in the background.
inline constexpr std::size_t kMostSamplesAtOnce = 30'000;

// At the beginning of a frame: what was rendered since, and what the last frame still wanted. An
// empty `wake`: the cache has no job.
void follow_render_job(VibrationCache& cache, const std::function<void()>& wake);

// The same while there are samples left to render; then what it was before, or null.
const Waveform* waveform_in_time(VibrationCache& cache, const Vibration& vibration);

// The peak of what waveform_in_time() gives; 0 for null.
double peak_in_time(const VibrationCache& cache, const Vibration& vibration);

// Updates the scales of the set when its revision changes or a peak becomes known. Until a pattern
// is rendered, its numbers give the peak.
void follow_reach(VibrationCache& cache, const PatternSet& set, std::uint64_t revision);

}  // namespace tact
