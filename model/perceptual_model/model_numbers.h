// Every parameter of the perceptual model, described once (model/text/described.h), in the order of
// files.
//
// Left out  the knots of the tables: model/io/set/model_json.h.
#pragma once

#include <array>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/text/described.h"

namespace tact {

namespace numbers {

// clang-format off
inline constexpr Number kExcitatoryLayers{.key = "excitatory_layers", .label = "Excitatory L_E",
    .format = "%.0f", .range = limits::kLayers, .slider = {0, 4}, .snap = 1,
    .help = "Excitatory layers of each relay network"};
inline constexpr Number kInhibitoryLayers = kExcitatoryLayers.as(
    "inhibitory_layers", "Inhibitory L_I", "Inhibitory layers of each relay network");
inline constexpr Number kPeakFraction{.key = "peak_fraction", .label = "Peaks from",
    .format = "%.3g of max", .range = limits::kShare, .slider = {0.0, 0.5}, .step = 0.01,
    .help = "Share of the largest amplitude from which a local maximum counts (components: peaks)"};
inline constexpr Number kBandPassOrder{.key = "band_pass_order_per_edge", .label = "Bandpass order",
    .format = "%.0f", .range = limits::kFilterOrder, .slider = {1, 12}, .snap = 1,
    .help = "Butterworth order of each edge; twice that in total"};
inline constexpr Number kLowPassOrder =
    kBandPassOrder.as("low_pass_order", "Lowpass order", "Butterworth order of the Merkel filter");
inline constexpr Number kSilentEnergy{.key = "silent_energy_fraction", .label = "Silence below",
    .format = "%.3g", .range = limits::kShare, .slider = {1e-15, 1e-3}, .step = 1e-12,
    .logarithmic = true,
    .help = "Share of the vibration's energy in a channel's band below which it is silent"};
inline constexpr Number kKernelCentre{.key = "centre", .label = "Core", .format = "%.4g",
    .range = limits::kKernel, .slider = {-8.0, 8.0}, .snap = 0.5,
    .help = "Weight of a neuron's own place", .kept = Kept::always};
inline constexpr Number kKernelArm =
    kKernelCentre.as("arm", "Arms", "Weight of its four neighbours");
inline constexpr Number kSpikeCap{.key = "spike_cap", .label = "Cap", .format = "%.0f",
    .range = limits::kSpikeCap, .slider = limits::kSpikeCap, .snap = 1,
    .help = "Most impulses of a cell in 5 ms; 50 samples at 10 kHz"};
inline constexpr Number kWaitingCost{.key = "waiting_cost", .label = "Waiting costs",
    .format = "%.3g", .range = limits::kWaitingCost, .slider = {0.0, 1.0}, .step = 0.05,
    .help = "In the OC part, of each sample at which one envelope waits for the other, in the "
            "envelope's unit. Free in the paper: how long notes last then counts nearly nothing"};
inline constexpr Number kNcWeight{.key = "nc_weight", .label = "NC weight", .format = "%.4g",
    .range = limits::kWeight, .slider = {0.0, 1.0}, .step = 0.1, .snap = 0.1,
    .help = "w_NC: weight of the ranks of NC, the neural coding, in PM"};
inline constexpr Number kOcWeight =
    kNcWeight.as("oc_weight", "OC weight", "w_OC: weight of the ranks of OC, the rhythm, in PM");
inline constexpr std::array<Number, kReceptorCount> kChannelWeights{
    kNcWeight.as("meissner", "Meissner weight",
                 "w_FA1: how much this type counts in the brain waveform"),
    kNcWeight.as("pacinian", "Pacinian weight",
                 "w_FA2: how much this type counts in the brain waveform"),
    kNcWeight.as("merkel", "Merkel weight",
                 "w_SA1: how much this type counts in the brain waveform"),
    kNcWeight.as("ruffini", "Ruffini weight",
                 "w_SA2: how much this type counts in the brain waveform")};
// clang-format on

}  // namespace numbers

// Enumerators by their words, in their order.
inline constexpr std::array<const char*, 2> kSkinInputs{"displacement", "acceleration"};
inline constexpr std::array<const char*, 2> kComponents{"all", "peaks"};
inline constexpr std::array<const char*, 2> kSubthreshold{"ignored", "subtracted"};
inline constexpr std::array<const char*, 2> kFireSharing{"total", "own"};
inline constexpr std::array<const char*, 2> kWindowSplits{"halves", "first"};
inline constexpr std::array<const char*, 2> kEnvelopeScales{"normalised", "raw"};
inline constexpr std::array<const char*, 2> kEnvelopeAlignments{"causal", "centred"};

template <class Visit>
void describe(Of<CrossKernel>, Visit&& visit) {
    visit(numbers::kKernelCentre, &CrossKernel::centre);
    visit(numbers::kKernelArm, &CrossKernel::arm);
}

template <class Visit>
void describe(Of<PhysiologyTables>, Visit&&) {}

template <class Visit>
void describe(Of<NeuralCodingParams>, Visit&& visit) {
    using Coding = NeuralCodingParams;
    visit(numbers::kExcitatoryLayers, &Coding::excitatory_layers);
    visit(numbers::kInhibitoryLayers, &Coding::inhibitory_layers);
    visit("remove_mean", &Coding::remove_mean);
    visit("skin_input", OneOf{kSkinInputs}, &Coding::skin_input);
    visit("components", OneOf{kComponents}, &Coding::components);
    visit(numbers::kPeakFraction, &Coding::peak_fraction);
    visit("subthreshold", OneOf{kSubthreshold}, &Coding::subthreshold);
    visit(numbers::kBandPassOrder, &Coding::band_pass_order_per_edge);
    visit(numbers::kLowPassOrder, &Coding::low_pass_order);
    visit(numbers::kSilentEnergy, &Coding::silent_energy_fraction);
    visit("share", OneOf{kFireSharing}, &Coding::share);
    visit("split", OneOf{kWindowSplits}, &Coding::split);
    visit("excitatory", &Coding::excitatory);
    visit("inhibitory", &Coding::inhibitory);
    visit(numbers::kSpikeCap, &Coding::spike_cap);
    visit("tables", &Coding::tables);
}

template <class Visit>
void describe(Of<EnvelopeParams>, Visit&& visit) {
    visit("scale", OneOf{kEnvelopeScales}, &EnvelopeParams::scale);
    visit("alignment", OneOf{kEnvelopeAlignments}, &EnvelopeParams::alignment);
    visit(numbers::kWaitingCost, &EnvelopeParams::waiting_cost);
}

template <class Visit>
void describe(Of<PerceptualModelParams>, Visit&& visit) {
    using Model = PerceptualModelParams;
    visit("coding", &Model::coding);
    visit("envelope", &Model::envelope);
    visit("channel_weight", numbers::kChannelWeights, &Model::channel_weight);
    visit(numbers::kNcWeight, &Model::nc_weight);
    visit(numbers::kOcWeight, &Model::oc_weight);
}

}  // namespace tact
