// Thresholds of receptor types in a spectrum: solid in a type's band, dashed outside, with a ghost
// of the previous ones; the mouse moves them. Private to the spectrum.
#pragma once

#include "viz/charts/spectrum_view.h"

namespace tact {

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
