#include "app/model_bench/model_rows.h"

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

const std::array<ModelChoice, 9> kChoices{{
    {"remove_mean",
     "Mean",
     "1/f\u00b2 would turn 1 mg of drift at 1 Hz into 248 \u00b5m.",
     {"kept", "removed"},
     [](const Model& m) { return m.coding.remove_mean ? 1 : 0; },
     [](Model& m, int v) { m.coding.remove_mean = v == 1; }},
    {"skin_input",
     "Skin input",
     "What Eq. 2 takes the logarithm of: peak displacement in \u00b5m, or the number of g as if it "
     "were \u00b5m.",
     {"displacement", "acceleration"},
     [](const Model& m) { return int(m.coding.skin_input); },
     [](Model& m, int v) { m.coding.skin_input = SkinInput(v); }},
    {"components",
     "Components",
     "Every bin of the spectrum above threshold, as the paper; or local maxima only, immune to "
     "leakage.",
     {"all", "peaks"},
     [](const Model& m) { return int(m.coding.components); },
     [](Model& m, int v) { m.coding.components = Components(v); }},
    {"subthreshold",
     "Below threshold",
     "Components below threshold count nothing, or take impulses away.",
     {"ignored", "subtracted"},
     [](const Model& m) { return int(m.coding.subthreshold); },
     [](Model& m, int v) { m.coding.subthreshold = Subthreshold(v); }},
    {"share",
     "Impulses",
     "The population's total is shared out by rate, as the paper's sentence; or every receptor "
     "fires at its own rate.",
     {"total", "own"},
     [](const Model& m) { return int(m.coding.share); },
     [](Model& m, int v) { m.coding.share = FireSharing(v); }},
    {"split",
     "10 ms window",
     "Its spikes fall into both halves of 5 ms, or all into the first.",
     {"halves", "first"},
     [](const Model& m) { return int(m.coding.split); },
     [](Model& m, int v) { m.coding.split = WindowSplit(v); }},
    {"envelope_scale",
     "Envelope",
     "Scaled to its own maximum: rhythm, not strength. Or left in g.",
     {"normalised", "raw"},
     [](const Model& m) { return int(m.envelope.scale); },
     [](Model& m, int v) { m.envelope.scale = EnvelopeScale(v); }},
    {"envelope_alignment",
     "Average",
     "Over the last 10 ms, or over 10 ms around each moment.",
     {"causal", "centred"},
     [](const Model& m) { return int(m.envelope.alignment); },
     [](Model& m, int v) { m.envelope.alignment = EnvelopeAlignment(v); }},
    {"thresholds",
     "Thresholds",
     "Rebuilt from published thresholds of each type of receptor; or these moved onto what the "
     "Android Open Source Project says is felt (rms difference 1.97 dB). None is chosen where "
     "knots "
     "were changed.",
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
