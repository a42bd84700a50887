// Short bursts in a signal: what stands out of its envelope for less than 60 ms, as a click, a
// drum's stroke or an accent does.
//
// The envelope is opened: what is left of it is what lasts 60 ms and more. A burst is where it
// holds half as much energy again as what is left. Its energy beyond that, the mean and the spread
// of its times give amplitude, middle and duration of a burst of a transient's form (Hann flanks of
// a quarter each, flat between). Four and more within 60 ms of each other are a tremor, and none of
// them a burst.
//
// Source    opening by a flat element: Serra 1982; the rest is ours
// Input     a signal, and its amplitude at 0, step, 2 step, ..
// Output    bursts in order; the amplitudes without them
// Valid     amplitudes of windows of 10 to 30 ms
// Left out  pitch, phase; a burst of less than a twentieth of the largest amplitude.
#pragma once

#include <span>
#include <vector>

#include "model/signal/waveform.h"

namespace tact {

struct ShortBurst {
    double begin_s = 0.0;
    double duration_s = 0.02;
    double amplitude_g = 0.0;

    bool operator==(const ShortBurst&) const = default;
};

struct BurstsFound {
    std::vector<ShortBurst> bursts;
    std::vector<double> rest_g;  // as many amplitudes as went in
};

BurstsFound short_bursts(const Waveform& signal, std::span<const double> envelope_g, double step_s);

}  // namespace tact
