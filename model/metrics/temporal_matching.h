// Mtm: one minus the correlation of two waveforms, sample by sample.
//
//     D = 1 - sum (x - mx)(y - my) / sqrt( sum (x - mx)^2 sum (y - my)^2 )
//
// The paper's table says that Mtm is the same for every pair of its AM set, which no maximum over
// lags would give, and that maps failed exactly where amplitudes alone differ, which only D = 0
// explains.
//
// Confidence  [M-H] the form, inferred from the paper's Table 2; [L] mean removed, sign kept
// Source    Park & Kuchenbecker 2019, as Lim & Park 2023 report it.
// Input     two waveforms of one length; sensitive to shifts in time
// Output    0..2; 0 between silences, 1 between silence and sound
#pragma once

#include <span>
#include <vector>

namespace tact {

enum class CorrelationSign {
    kept,    // 1 - r
    dropped  // 1 - |r|
};

enum class CorrelationLag {
    none,
    best  // r at its largest over all lags: not the paper's, and quadratic in the length
};

struct TemporalMatchingParams {
    bool removes_mean = true;
    CorrelationSign sign = CorrelationSign::kept;
    CorrelationLag lag = CorrelationLag::none;

    bool operator==(const TemporalMatchingParams&) const = default;
};

// A waveform as it is compared.
struct CentredSamples {
    std::vector<double> samples;
    double energy = 0.0;  // sum of squares; 0 for what is constant but for rounding
};

CentredSamples centred_samples(std::span<const double> samples,
                               const TemporalMatchingParams& params = {});

double temporal_matching(const CentredSamples& x, const CentredSamples& y,
                         const TemporalMatchingParams& params = {});

}  // namespace tact
