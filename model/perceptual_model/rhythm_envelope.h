// The rhythm of a vibration as its envelope: one-dimensional convolution with a 10 ms mean.
//
//     y[n] = (1/100) sum_{m=0..99} |x[n-m]|,   then y / max y
//
// Normalised, OC is about rhythm, which is what the paper says it is for; raw, amplitude twins of
// one rhythm come out farther apart than average, against its findings.
//
// Centred, the mean is of x[n-49] .. x[n+50]. Samples before the start and past the end are zeros
// and count, so that a rhythm that is cut off rises and falls at the ends. MATLAB's movmean(x, 100)
// takes x[n-50] .. x[n+49] and, at the ends, the mean of the samples there are.
//
// It is taken of what reaches the skin, so a drawn amplitude and transients are part of it as ramps
// and modulation are: a pulse is felt as an onset whether it was written as a note or drawn.
//
// Source    Lim & Park 2023, section 5; alignment and normalisation are ours.
// Input     samples in g at 10 kHz, mean not removed
// Output    as many values; silence stays zero
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"

namespace tact {

inline constexpr std::size_t kEnvelopeSamples = 100;  // 10 ms

std::vector<double> rhythm_envelope(std::span<const double> samples_g,
                                    const EnvelopeParams& params);

// The envelope of samples that are followed by zeros, up to `samples` in all: its values up to the
// last that is not zero.
std::vector<double> own_rhythm_envelope(std::span<const double> samples_g, std::size_t samples,
                                        const EnvelopeParams& params);

// The sums of |x| over windows, by one of the instruction sets this processor has, the fastest
// first: sums[k] is of kEnvelopeSamples sizes from sizes[k] on, for a multiple of 16 sums.
struct WindowSummer {
    const char* name;
    void (*sum)(const double* sizes, std::span<double> sums);
};
std::span<const WindowSummer> window_summers();

// Means of consecutive blocks, the last one possibly shorter: a coarse envelope for previews. Zeros
// follow the envelope, up to `samples` in all; blocks that hold nothing else are left out.
std::vector<double> decimated(std::span<const double> envelope, std::size_t factor,
                              std::size_t samples = 0);

}  // namespace tact
