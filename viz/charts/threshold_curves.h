// Thresholds of receptor types in a spectrum: whole in a type's band, dashed beyond it, a ghost
// where they were, and taken by the mouse. Private to the spectrum.
#pragma once

#include "viz/charts/spectrum_view.h"

namespace tact {

// Of a type that was removed: beyond any vibration.
inline constexpr double kOutOfReachDb = 119.0;

double threshold_db(const Curve& threshold, double frequency_hz);

void draw_threshold(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                    const Curve& threshold, ImU32 colour);

// Curves as they were before they were changed.
void draw_ghosts(ImDrawList& list, const Theme& theme, const Plot& plot,
                 const SpectrumScene& scene);

// Where Pacinian corpuscles are most sensitive, between round ticks: in a wide plot it is read.
void draw_tick_of_peak(ImDrawList& list, const Theme& theme, const Plot& plot);

// What was measured: points of least displacements that are felt, and bars at the foot.
void draw_measured(ImDrawList& list, const Theme& theme, const Plot& plot,
                   const SpectrumScene& scene);

// After the plot's button.
void take_curve(const char* id, const Theme& theme, const Plot& plot, const SpectrumScene& scene,
                SpectrumAction& action);

}  // namespace tact
