// How one receptor comes to fire, on one time axis: the perceived waveform, the energy since its
// last spike against the threshold, the windows of 10 ms at whose ends the two are compared, and
// the spikes.
//
// Source    Lim & Park 2023, section 4.2 and Figure 4
// Input     views into the stages of one channel (model/physiology/neural_coding.h)
// Left out  the mouse: a picture for a page.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/physiology/mechanoreceptor.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

struct FiringScene {
    Receptor receptor = Receptor::pacinian;
    std::span<const double> perceived{};  // one value per sample at 10 kHz
    std::span<const int> spikes{};        // one count per step of 5 ms
    double fires = 0.0;                   // total spikes of the signal, not rounded
    double start_s = 0.0;
    double end_s = 1.0;
};

// Energy since the last spike, in units of the threshold, after each sample of the perceived
// waveform: it falls by whole numbers at the end of each window.
std::vector<double> energy_since_spike(std::span<const double> perceived, double fires);

// The time range that shows a receptor firing: about its first dozen spikes, in whole windows.
std::pair<double, double> telling_time_s(std::span<const int> spikes);

void draw_firing(const Theme& theme, const Rect& area, const FiringScene& scene);

}  // namespace tact
