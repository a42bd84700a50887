#include "app/model_bench/model_rows.h"

#include <cmath>

namespace tact {

namespace {

using Model = PerceptualModelParams;

constexpr Field layers(const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.0f",
            .slider = {0, 4},
            .typed = limits::kLayers,
            .step = 1,
            .snap = 1,
            .help = help};
}

constexpr Field weight(const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.4g",
            .slider = {0.0, 1.0},
            .typed = limits::kWeight,
            .step = 0.1,
            .snap = 0.1,
            .help = help};
}

constexpr Field kernel(const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.4g",
            .slider = {-8.0, 8.0},
            .typed = limits::kKernel,
            .step = 1.0,
            .snap = 0.5,
            .help = help};
}

constexpr Field order(const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.0f",
            .slider = {1, 12},
            .typed = limits::kFilterOrder,
            .step = 1,
            .snap = 1,
            .help = help};
}

int whole(double value) { return static_cast<int>(std::lround(value)); }

const std::array<ModelNumber, 8> kTrained{{
    {layers("excitatory_layers", "Excitatory L_E", "Excitatory layers of each relay network"),
     [](const Model& m) { return double(m.coding.excitatory_layers); },
     [](Model& m, double v) { m.coding.excitatory_layers = whole(v); }},
    {layers("inhibitory_layers", "Inhibitory L_I", "Inhibitory layers of each relay network"),
     [](const Model& m) { return double(m.coding.inhibitory_layers); },
     [](Model& m, double v) { m.coding.inhibitory_layers = whole(v); }},
    {weight("weight_FA1", "Meissner weight",
            "w_FA1: how much this type counts in the brain waveform"),
     [](const Model& m) { return m.channel_weight[0]; },
     [](Model& m, double v) { m.channel_weight[0] = v; }},
    {weight("weight_FA2", "Pacinian weight",
            "w_FA2: how much this type counts in the brain waveform"),
     [](const Model& m) { return m.channel_weight[1]; },
     [](Model& m, double v) { m.channel_weight[1] = v; }},
    {weight("weight_SA1", "Merkel weight",
            "w_SA1: how much this type counts in the brain waveform"),
     [](const Model& m) { return m.channel_weight[2]; },
     [](Model& m, double v) { m.channel_weight[2] = v; }},
    {weight("weight_SA2", "Ruffini weight",
            "w_SA2: how much this type counts in the brain waveform"),
     [](const Model& m) { return m.channel_weight[3]; },
     [](Model& m, double v) { m.channel_weight[3] = v; }},
    {weight("weight_NC", "NC weight", "w_NC: weight of the ranks of NC, the neural coding, in PM"),
     [](const Model& m) { return m.nc_weight; }, [](Model& m, double v) { m.nc_weight = v; }},
    {weight("weight_OC", "OC weight", "w_OC: weight of the ranks of OC, the rhythm, in PM"),
     [](const Model& m) { return m.oc_weight; }, [](Model& m, double v) { m.oc_weight = v; }},
}};

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

const std::array<ModelNumber, 10> kNumbers{{
    {{.id = "peak_fraction",
      .label = "Peaks from",
      .format = "%.3g of max",
      .slider = {0.0, 0.5},
      .typed = limits::kShare,
      .step = 0.01,
      .help =
          "Share of the largest amplitude from which a local maximum counts (components: peaks)"},
     [](const Model& m) { return m.coding.peak_fraction; },
     [](Model& m, double v) { m.coding.peak_fraction = v; }},
    {order("band_pass_order", "Bandpass order",
           "Butterworth order of each edge; twice that in total"),
     [](const Model& m) { return double(m.coding.band_pass_order_per_edge); },
     [](Model& m, double v) { m.coding.band_pass_order_per_edge = whole(v); }},
    {order("low_pass_order", "Lowpass order", "Butterworth order of the Merkel filter"),
     [](const Model& m) { return double(m.coding.low_pass_order); },
     [](Model& m, double v) { m.coding.low_pass_order = whole(v); }},
    {kernel("excitatory_centre", "Excitatory core",
            "Eq. 5, the kernel E: weight of a neuron's own place"),
     [](const Model& m) { return m.coding.excitatory.centre; },
     [](Model& m, double v) { m.coding.excitatory.centre = v; }},
    {kernel("excitatory_arm", "Excitatory arms",
            "Eq. 5, the kernel E: weight of its four neighbours"),
     [](const Model& m) { return m.coding.excitatory.arm; },
     [](Model& m, double v) { m.coding.excitatory.arm = v; }},
    {kernel("inhibitory_centre", "Inhibitory core",
            "Eq. 6, the kernel I, whose numbers are lost: ours. A neuron's own place"),
     [](const Model& m) { return m.coding.inhibitory.centre; },
     [](Model& m, double v) { m.coding.inhibitory.centre = v; }},
    {kernel("inhibitory_arm", "Inhibitory arms",
            "Eq. 6, the kernel I, whose numbers are lost: ours. Its four neighbours"),
     [](const Model& m) { return m.coding.inhibitory.arm; },
     [](Model& m, double v) { m.coding.inhibitory.arm = v; }},
    {{.id = "spike_cap",
      .label = "Cap",
      .format = "%.0f",
      .slider = limits::kSpikeCap,
      .typed = limits::kSpikeCap,
      .step = 1,
      .snap = 1,
      .help = "Most impulses of a cell in 5 ms; 50 samples at 10 kHz"},
     [](const Model& m) { return double(m.coding.spike_cap); },
     [](Model& m, double v) { m.coding.spike_cap = whole(v); }},
    {{.id = "silent_energy_fraction",
      .label = "Silence below",
      .format = "%.3g",
      .slider = {1e-15, 1e-3},
      .typed = limits::kShare,
      .step = 1e-12,
      .logarithmic = true,
      .help = "Share of the vibration's energy in a channel's band below which it is silent"},
     [](const Model& m) { return m.coding.silent_energy_fraction; },
     [](Model& m, double v) { m.coding.silent_energy_fraction = v; }},
    {{.id = "waiting_cost",
      .label = "Waiting costs",
      .format = "%.3g",
      .slider = {0.0, 1.0},
      .typed = limits::kWaitingCost,
      .step = 0.05,
      .help = "In the OC part, of each sample at which one envelope waits for the other, in the "
              "envelope's unit. Free in the paper: how long notes last then counts nearly nothing"},
     [](const Model& m) { return m.envelope.waiting_cost; },
     [](Model& m, double v) { m.envelope.waiting_cost = v; }},
}};

}  // namespace

std::span<const ModelNumber> trained_rows() { return kTrained; }
std::span<const ModelChoice> choice_rows() { return kChoices; }
std::span<const ModelNumber> number_rows() { return kNumbers; }

}  // namespace tact
