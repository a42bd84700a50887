#include "app/model_bench/parts.h"

#include "model/perceptual_model/model_numbers.h"

namespace tact {

namespace {

using Model = PerceptualModelParams;

using Coding = NeuralCodingParams;

template <const Number& number, auto... path>
constexpr ModelNumber number_row(const char* id) {
    return described_field<number, Model, path...>(id);
}

template <const Number& number, auto member>
constexpr ModelNumber coding_row(const char* id) {
    return number_row<number, &Model::coding, member>(id);
}

template <std::size_t receptor>
constexpr ModelNumber weight_row(const char* id) {
    return {field_of(numbers::kChannelWeights[receptor], id),
            [](const Model& m) { return m.channel_weight[receptor]; },
            [](Model& m, double v) { m.channel_weight[receptor] = v; }};
}

// A number of one of the two kernels, which have the same.
template <const Number& number, auto kernel, auto member>
constexpr ModelNumber kernel_row(const char* id, const char* label, const char* help) {
    ModelNumber row = number_row<number, &Model::coding, kernel, member>(id);
    row.field.label = label;
    row.field.help = help;
    return row;
}

constexpr std::array kTrained{
    coding_row<numbers::kExcitatoryLayers, &Coding::excitatory_layers>("excitatory_layers"),
    coding_row<numbers::kInhibitoryLayers, &Coding::inhibitory_layers>("inhibitory_layers"),
    weight_row<0>("weight_FA1"),
    weight_row<1>("weight_FA2"),
    weight_row<2>("weight_SA1"),
    weight_row<3>("weight_SA2"),
    number_row<numbers::kNcWeight, &Model::nc_weight>("weight_NC"),
    number_row<numbers::kOcWeight, &Model::oc_weight>("weight_OC")};

// A choice by the words that files have for it.
template <const auto& words, auto part, auto member>
constexpr ModelChoice choice_row(const char* id, const char* label, const char* help) {
    return {id,
            label,
            help,
            words,
            [](const Model& m) { return static_cast<int>(m.*part.*member); },
            [](Model& m, int v) {
                auto& value = m.*part.*member;
                value = static_cast<std::remove_reference_t<decltype(value)>>(v);
            }};
}

constexpr std::array<const char*, 2> kMeans{"kept", "removed"};

const std::array<ModelChoice, 9> kChoices{{
    choice_row<kMeans, &Model::coding, &Coding::remove_mean>(
        "remove_mean", "Mean", "1/f\u00b2 would turn 1 mg of drift at 1 Hz into 248 \u00b5m."),
    choice_row<kSkinInputs, &Model::coding, &Coding::skin_input>(
        "skin_input", "Skin input",
        "What Eq. 2 takes the logarithm of: peak displacement in \u00b5m, or the number of g as if "
        "it "
        "were \u00b5m."),
    choice_row<kComponents, &Model::coding, &Coding::components>(
        "components", "Components",
        "Every bin of the spectrum above threshold, as the paper; or local maxima only, immune to "
        "leakage."),
    choice_row<kSubthreshold, &Model::coding, &Coding::subthreshold>(
        "subthreshold", "Below threshold",
        "Components below threshold count nothing, or take impulses away."),
    choice_row<kFireSharing, &Model::coding, &Coding::share>(
        "share", "Impulses",
        "The population's total is shared out by rate, as the paper's sentence; or every receptor "
        "fires at its own rate."),
    choice_row<kWindowSplits, &Model::coding, &Coding::split>(
        "split", "10 ms window",
        "Its spikes fall into both halves of 5 ms, or all into the first."),
    choice_row<kEnvelopeScales, &Model::envelope, &EnvelopeParams::scale>(
        "envelope_scale", "Envelope",
        "Scaled to its own maximum: rhythm, not strength. Or left in g."),
    choice_row<kEnvelopeAlignments, &Model::envelope, &EnvelopeParams::alignment>(
        "envelope_alignment", "Average", "Over the last 10 ms, or over 10 ms around each moment."),
    {"thresholds",
     "Thresholds",
     "Rebuilt from published thresholds of each type of receptor; or these moved onto what the "
     "Android Open Source Project says is felt (rms difference 1.97 dB). None is chosen where "
     "knots were changed.",
     {"rebuilt", "AOSP"},
     [](const Model& m) {
         const auto& now = m.coding.tables.threshold;
         return now == default_tables().threshold ? 0 : now == aosp_thresholds() ? 1 : 2;
     },
     [](Model& m, int v) {
         m.coding.tables.threshold = v == 0 ? default_tables().threshold : aosp_thresholds();
     }},
}};

constexpr std::array kNumbers{
    coding_row<numbers::kPeakFraction, &Coding::peak_fraction>("peak_fraction"),
    coding_row<numbers::kBandPassOrder, &Coding::band_pass_order_per_edge>("band_pass_order"),
    coding_row<numbers::kLowPassOrder, &Coding::low_pass_order>("low_pass_order"),
    kernel_row<numbers::kKernelCentre, &Coding::excitatory, &CrossKernel::centre>(
        "excitatory_centre", "Excitatory core",
        "Eq. 5, the kernel E: weight of a neuron's own place"),
    kernel_row<numbers::kKernelArm, &Coding::excitatory, &CrossKernel::arm>(
        "excitatory_arm", "Excitatory arms", "Eq. 5, the kernel E: weight of its four neighbours"),
    kernel_row<numbers::kKernelCentre, &Coding::inhibitory, &CrossKernel::centre>(
        "inhibitory_centre", "Inhibitory core",
        "Eq. 6, the kernel I, whose numbers are lost: ours. A neuron's own place"),
    kernel_row<numbers::kKernelArm, &Coding::inhibitory, &CrossKernel::arm>(
        "inhibitory_arm", "Inhibitory arms",
        "Eq. 6, the kernel I, whose numbers are lost: ours. Its four neighbours"),
    coding_row<numbers::kSpikeCap, &Coding::spike_cap>("spike_cap"),
    coding_row<numbers::kSilentEnergy, &Coding::silent_energy_fraction>("silent_energy_fraction"),
    number_row<numbers::kWaitingCost, &Model::envelope, &EnvelopeParams::waiting_cost>(
        "waiting_cost")};

}  // namespace

std::span<const ModelNumber> trained_rows() { return kTrained; }
std::span<const ModelChoice> choice_rows() { return kChoices; }
std::span<const ModelNumber> number_rows() { return kNumbers; }

}  // namespace tact
