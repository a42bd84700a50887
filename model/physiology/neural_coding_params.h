// Everything a researcher may choose in neural coding: the two trained layer counts of the paper,
// and each choice of ours where the paper leaves one open.
//
// Source    Lim & Park 2023, sections 4 and 5; choices marked [ours] are argued in the comments.
#pragma once

#include "model/common/units.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

// The spectral components that drive the receptors.
enum class Components {
    all,   // every DFT bin above threshold: the paper
    peaks  // [ours] local maxima only; immune to leakage of frequencies between bins
};

// Effect of a component below threshold on the mean rate.
enum class Subthreshold {
    ignored,    // [ours] it adds nothing
    subtracted  // Eq. 2 read literally: it takes impulses away
};

// How the population's impulses are divided.
enum class FireSharing {
    total,  // the paper's sentence: N f0 T, in the ratio of the rates
    own     // every receptor at its own rate
};

// Distribution of the n spikes of a 10 ms window.
enum class WindowSplit {
    halves,  // [ours] ceil(n/2) in the first 5 ms, the rest in the second
    first    // all in the first
};

// The amplitude at the skin in the logarithm of Eq. 2.
enum class SkinInput {
    displacement,  // [ours] um, from acceleration by 1/(2 pi f)^2, as thresholds are in um
    acceleration   // the number of g taken as um
};

// Weights of the cross-shaped receptive field of a relay neuron.
struct CrossKernel {
    double centre = 1.0;
    double arm = 1.0;

    bool operator==(const CrossKernel&) const = default;
};

// Ranges of a researcher's choices. Panels clamp to these; files outside them are refused.
namespace limits {
inline constexpr Range kLayers{0, 16};  // the paper trains 0 to 4
inline constexpr Range kFilterOrder{1, 20};
inline constexpr Range kShare{0.0, 1.0};
inline constexpr Range kKernel{-100.0, 100.0};
inline constexpr Range kSpikeCap{1, 50};  // samples in 5 ms
}  // namespace limits

struct NeuralCodingParams {
    // Trained in the paper.
    int excitatory_layers = 3;
    int inhibitory_layers = 1;

    // Choices.
    bool remove_mean = true;  // [ours] 1/f^2 turns 1 mg of drift at 1 Hz into 248 um
    SkinInput skin_input = SkinInput::displacement;
    Components components = Components::all;
    double peak_fraction = 0.03;  // [ours] relative to the largest amplitude, for Components::peaks
    Subthreshold subthreshold = Subthreshold::ignored;
    int band_pass_order_per_edge = 5;       // [ours] order 10 in total
    int low_pass_order = 10;                // [ours]
    double silent_energy_fraction = 1e-12;  // [ours] relative to the input's energy: below, the
                                            // channel is silent
    FireSharing share = FireSharing::total;
    WindowSplit split = WindowSplit::halves;
    CrossKernel excitatory{1.0, 1.0};   // Eq. 5
    CrossKernel inhibitory{5.0, -1.0};  // [ours] Eq. 6's numbers are lost
    int spike_cap = 50;                 // impulses in 5 ms at 10 kHz
    PhysiologyTables tables = default_tables();

    bool operator==(const NeuralCodingParams&) const = default;
};

}  // namespace tact
