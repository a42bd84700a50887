// The components of a vibration that the four receptor types can feel: displacement over frequency,
// against the types' thresholds.
//
// Source    thresholds: the model's own tables, so that the picture and the prediction agree.
// Input     an amplitude spectrum in g; 1-500 Hz of it are shown
// Output    the component under the mouse
// A threshold is dashed outside the band of its type (mechanoreceptor.h).
// Left out  phase, components below 1e-9 g (the model ignores them too).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "model/common/units.h"
#include "model/physiology/activation.h"
#include "viz/drawing/plot.h"

namespace tact {

struct MeasuredBand {
    Receptor receptor = Receptor::meissner;
    Range hz{1.0, 500.0};
};

struct SpectrumScene {
    std::span<const Component> components{};         // by ascending frequency
    const PerReceptor<Curve>* thresholds = nullptr;  // log10 um; never null
    const PerReceptor<Curve>* ghosts = nullptr;      // previous thresholds, if they differ; or null
    ImU32 colour = 0;                                // colour of components that are felt
    bool stale = false;
    bool curves_move = false;  // the mouse can move thresholds
    // Measured facts, in a neutral colour: the smallest displacements that are felt, Hz and dB; and
    // the frequencies at which a type is most sensitive, as bars at the bottom.
    std::span<const std::pair<double, double>> felt_db{};
    std::span<const MeasuredBand> bands{};
};

struct SpectrumAction {
    std::optional<std::size_t> hovered{};  // index of a component
    std::optional<Receptor> taken{};       // the type whose threshold the mouse holds
    double moved_db = 0.0;                 // the movement in this frame
    bool released = false;                 // the mouse has released it
};

SpectrumAction draw_spectrum(const char* id, const Theme& theme, const Rect& area,
                             const SpectrumScene& scene);

// 20 log10 of the peak displacement in um; -infinity for silence.
double level_db(const Component& component);

// For each receptor type: whether a component reaches its threshold.
PerReceptor<bool> reached(std::span<const Component> components,
                          const PerReceptor<Curve>& thresholds);

// Tops of labels of equal height with these wanted tops, moved apart so that they do not overlap,
// all within [low, high] if they fit there. Keeps the order of `wanted`.
std::vector<float> spread(std::span<const float> wanted, float height, float low, float high);

}  // namespace tact
