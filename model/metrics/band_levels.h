// R4: nine numbers of a vibration, how far each band is above the threshold of feeling.
//
//     L_b = 10 log10 max(1, sum_{k in b} (v_k / v_0(f_k))^2) dB,   D = |L_x - L_y|
//
// v_k is the displacement of a line and v_0 the lowest of the four receptors' thresholds there.
//
// Confidence  [H] ours, not from the paper: what a band-wise spectrum with thresholds explains,
//           without receptors, spikes or networks
// Source    thresholds: those of the perceptual model (model/physiology/mechanoreceptor.h)
// Input     spectrum of a waveform without its mean
// Output    dB over threshold in nine bands of equal ratio, 5-1000 Hz; what is not felt is 0
// Left out  masking, and anything in time. Thresholds above 500 Hz are held at their last value.
#pragma once

#include <array>

#include "model/physiology/mechanoreceptor.h"
#include "model/signal/spectrum.h"

namespace tact {

inline constexpr std::size_t kBandCount = 9;
inline constexpr double kLowestBandHz = 5.0;
inline constexpr double kHighestBandHz = 1000.0;  // in the last band

using BandLevels = std::array<double, kBandCount>;

BandLevels band_levels_db(const Spectrum& spectrum, const PhysiologyTables& tables);

// Euclidean.
double band_distance(const BandLevels& x_db, const BandLevels& y_db);

}  // namespace tact
