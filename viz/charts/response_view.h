// The response of an actuator to full scale: g over frequency, both logarithmic.
//
// Input     the table by ascending frequency, and tones too distorted or too faint for it
// Output    the point of the table under the mouse
// Left out  phase.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "model/common/units.h"
#include "model/physiology/mechanoreceptor.h"
#include "viz/charts/spectrum_view.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/theme.h"

namespace tact {

struct ResponseMark {
    double frequency_hz = 0.0;
    double g = 0.0;  // per full scale; values up to 0 are not drawn
};

struct ResponseScene {
    std::span<const ResponseMark> table{};
    std::span<const ResponseMark> refused{};  // rings in the warning colour
};

struct ResponseAction {
    std::optional<std::size_t> hovered{};  // index into the table
};

ResponseAction draw_response(const char* id, const Theme& theme, const Rect& area,
                             const ResponseScene& scene);

// A curve over frequency for each receptor type: solid in the type's band, dashed outside.
//
// Source    Lim & Park 2023, Figure 5 (slopes and thresholds)
// Left out  the mouse, names of the curves: draw_receptor_mark() beside them labels them.

// For a plot with frequency along x. `value`: the curve at a frequency in Hz.
void draw_over_frequency(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                         const std::function<double(double)>& value, ImU32 colour);

struct ReceptorCurves {
    const PerReceptor<Curve>* curves = nullptr;  // never null
    Range frequency_hz{1.0, 500.0};
    Range values{0.0, 1.0};  // at the bottom and the top
    std::string_view unit{};
};

void draw_receptor_curves(const Theme& theme, const Rect& area, const ReceptorCurves& scene);

// Thresholds of receptor types in a spectrum: solid in a type's band, dashed outside, with a ghost
// of the previous ones; the mouse moves them. Private to the spectrum.

// The threshold of a removed type: above any vibration.
inline constexpr double kOutOfReachDb = 119.0;

double threshold_db(const Curve& threshold, double frequency_hz);

void draw_threshold(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                    const Curve& threshold, ImU32 colour);

// The curves before they were changed.
void draw_ghosts(ImDrawList& list, const Theme& theme, const Plot& plot,
                 const SpectrumScene& scene);

// The most sensitive frequency of Pacinian corpuscles, between round ticks: labelled in a wide
// plot.
void draw_tick_of_peak(ImDrawList& list, const Theme& theme, const Plot& plot);

// Measured facts: points of the smallest displacements that are felt, and bars at the bottom.
void draw_measured(ImDrawList& list, const Theme& theme, const Plot& plot,
                   const SpectrumScene& scene);

// Call after the plot's button.
void take_curve(const char* id, const Theme& theme, const Plot& plot, const SpectrumScene& scene,
                SpectrumAction& action);

}  // namespace tact
