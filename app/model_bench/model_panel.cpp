// The model bench: every parameter of PM, what the paper gives, what is ours, and what was changed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/document/editing.h"
#include "app/model_bench/model_panel.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using Model = PerceptualModelParams;

// A number of the model.
struct NumberRow {
    Field field;
    double (*get)(const Model&);
    void (*set)(Model&, double);
};

// One of a few ways to do something.
struct ChoiceRow {
    const char* id;
    const char* label;
    const char* help;
    std::array<const char*, 2> options;
    int (*get)(const Model&);
    void (*set)(Model&, int);
};

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

const std::array<NumberRow, 8> kTrained{{
    {layers("excitatory_layers", "L_E", "Excitatory layers of each relay network"),
     [](const Model& m) { return double(m.coding.excitatory_layers); },
     [](Model& m, double v) { m.coding.excitatory_layers = whole(v); }},
    {layers("inhibitory_layers", "L_I", "Inhibitory layers of each relay network"),
     [](const Model& m) { return double(m.coding.inhibitory_layers); },
     [](Model& m, double v) { m.coding.inhibitory_layers = whole(v); }},
    {weight("weight_FA1", "w Meissner", "Weight of FA1 in the brain waveform"),
     [](const Model& m) { return m.channel_weight[0]; },
     [](Model& m, double v) { m.channel_weight[0] = v; }},
    {weight("weight_FA2", "w Pacinian", "Weight of FA2 in the brain waveform"),
     [](const Model& m) { return m.channel_weight[1]; },
     [](Model& m, double v) { m.channel_weight[1] = v; }},
    {weight("weight_SA1", "w Merkel", "Weight of SA1 in the brain waveform"),
     [](const Model& m) { return m.channel_weight[2]; },
     [](Model& m, double v) { m.channel_weight[2] = v; }},
    {weight("weight_SA2", "w Ruffini", "Weight of SA2 in the brain waveform"),
     [](const Model& m) { return m.channel_weight[3]; },
     [](Model& m, double v) { m.channel_weight[3] = v; }},
    {weight("weight_NC", "w NC", "Weight of neural coding's ranks in PM"),
     [](const Model& m) { return m.nc_weight; }, [](Model& m, double v) { m.nc_weight = v; }},
    {weight("weight_OC", "w OC", "Weight of the rhythm's ranks in PM"),
     [](const Model& m) { return m.oc_weight; }, [](Model& m, double v) { m.oc_weight = v; }},
}};

const std::array<ChoiceRow, 8> kChoices{{
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
}};

const std::array<NumberRow, 9> kNumbers{{
    {{.id = "peak_fraction",
      .label = "Peaks from",
      .format = "%.3g",
      .slider = {0.0, 0.5},
      .typed = limits::kShare,
      .step = 0.01,
      .help =
          "Share of the largest amplitude from which a local maximum counts (components: peaks)"},
     [](const Model& m) { return m.coding.peak_fraction; },
     [](Model& m, double v) { m.coding.peak_fraction = v; }},
    {order("band_pass_order", "Band-pass", "Butterworth order of each edge; twice that in total"),
     [](const Model& m) { return double(m.coding.band_pass_order_per_edge); },
     [](Model& m, double v) { m.coding.band_pass_order_per_edge = whole(v); }},
    {order("low_pass_order", "Low-pass", "Butterworth order of the Merkel filter"),
     [](const Model& m) { return double(m.coding.low_pass_order); },
     [](Model& m, double v) { m.coding.low_pass_order = whole(v); }},
    {kernel("excitatory_centre", "E centre", "Eq. 5: weight of a neuron's own place"),
     [](const Model& m) { return m.coding.excitatory.centre; },
     [](Model& m, double v) { m.coding.excitatory.centre = v; }},
    {kernel("excitatory_arm", "E arms", "Eq. 5: weight of its four neighbours"),
     [](const Model& m) { return m.coding.excitatory.arm; },
     [](Model& m, double v) { m.coding.excitatory.arm = v; }},
    {kernel("inhibitory_centre", "I centre", "The numbers of Eq. 6 are lost: ours"),
     [](const Model& m) { return m.coding.inhibitory.centre; },
     [](Model& m, double v) { m.coding.inhibitory.centre = v; }},
    {kernel("inhibitory_arm", "I arms", "The numbers of Eq. 6 are lost: ours"),
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
}};

void change_model(Workspace& work, const std::function<void(Model&)>& change) {
    change(work.document.set.model);
    document_changed(work);
}

void commit_model(Ui& ui, Workspace& work, const std::string& what) {
    commit_step(ui, work, "Change " + what);
}

// After a row that was changed: what it was, and the way back. True when pressed.
bool draw_way_back(Ui& ui, const char* id, bool changed, const std::string& original) {
    if (!changed) return false;
    flow_on(ImGui::CalcTextSize(original.c_str()).x, ui.theme.gap_px * 0.5F);
    ImGui::PushID(id);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + ImGui::GetStyle().FramePadding.y});
    const bool pressed = link(ui, "back", original);
    note_item(ui.rects, std::string("reset:") + id, original);
    draw_tooltip(ui, "Changed. Click to go back to this value.");
    ImGui::PopID();
    return pressed;
}

void draw_number(Ui& ui, Workspace& work, const NumberRow& row, const Model& original) {
    const double before = row.get(work.document.set.model);
    const double known = row.get(original);
    double value = before;
    const float room = 56.0F * ui.theme.scale;
    ImGui::BeginGroup();
    Field field = row.field;
    field.right_room_px = room;
    const FieldEdit edit = draw_field(ui, field, value);
    ImGui::EndGroup();
    if (edit.changed) change_model(work, [&](Model& m) { row.set(m, value); });
    if (edit.finished) commit_model(ui, work, row.field.label);
    char text[32];
    std::snprintf(text, sizeof text, row.field.format, known);
    if (draw_way_back(ui, row.field.id, before != known, text)) {
        change_model(work, [&](Model& m) { row.set(m, known); });
        commit_model(ui, work, row.field.label);
    }
}

void draw_choice(Ui& ui, Workspace& work, const ChoiceRow& row, const Model& original) {
    const int before = row.get(work.document.set.model);
    const int known = row.get(original);
    ImGui::PushID(row.id);
    const float gap = 1.5F * ui.theme.gap_px;
    draw_label(ui, row.label,
               radio_width(ui, row.options[0]) + gap + radio_width(ui, row.options[1]));
    draw_tooltip(ui, row.help);
    for (int k = 0; k < 2; ++k) {
        const char* option = row.options[static_cast<std::size_t>(k)];
        if (k > 0) flow_on(radio_width(ui, option), gap);
        if (draw_radio(ui, option, before == k) && before != k) {
            change_model(work, [&](Model& m) { row.set(m, k); });
            commit_model(ui, work, row.label);
        }
        note_item(ui.rects, std::string("choice:") + row.id + " " + option,
                  before == k ? "chosen" : "");
        draw_tooltip(ui, row.help);
    }
    if (draw_way_back(ui, row.id, before != known, row.options[static_cast<std::size_t>(known)])) {
        change_model(work, [&](Model& m) { row.set(m, known); });
        commit_model(ui, work, row.label);
    }
    ImGui::PopID();
}

void draw_heading(const Ui& ui, const char* text, const char* detail) {
    ImGui::Dummy({1.0F, ui.theme.gap_px * 0.5F});
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, detail);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

// How many parameters are not as they come.
int count_changed(const Model& model, const Model& original) {
    int count = 0;
    for (const NumberRow& row : kTrained) count += row.get(model) != row.get(original);
    for (const NumberRow& row : kNumbers) count += row.get(model) != row.get(original);
    for (const ChoiceRow& row : kChoices) count += row.get(model) != row.get(original);
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        count += model.coding.tables.slope[c] != original.coding.tables.slope[c];
        count += model.coding.tables.threshold[c] != original.coding.tables.threshold[c];
    }
    return count;
}

void draw_summary(Ui& ui, Workspace& work, const Model& original) {
    const int changed = count_changed(work.document.set.model, original);
    if (changed == 0) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui,
                 "As published: trained parameters of the paper, choices of ours where it "
                 "leaves one open.");
        ImGui::PopTextWrapPos();
        return;
    }
    char text[96];
    std::snprintf(text, sizeof text,
                  changed == 1 ? "%d parameter changed." : "%d parameters changed.", changed);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    note_item(ui.rects, "model:changed", std::to_string(changed));
    constexpr const char* kBack = "Back to the paper's";
    flow_on(ImGui::CalcTextSize(kBack).x, ui.theme.gap_px);
    if (link(ui, "reset model", kBack)) {
        change_model(work, [&](Model& m) { m = original; });
        commit_model(ui, work, "the model back to the paper's");
    }
    note_item(ui.rects, "reset:model");
}

void draw_views(Ui& ui, ModelBench& model_bench) {
    const auto view = [&](ModelView which, const char* name) {
        if (draw_chip(ui, name, name, model_bench.panel.view == which))
            model_bench.panel.view = which;
        note_item(ui.rects, std::string("model:") + name);
    };
    view(ModelView::parameters, "Parameters");
    flow_on(chip_width(ui, "Train on ratings"), 2.0F * ui.theme.scale);
    view(ModelView::training, "Train on ratings");
    ImGui::Dummy({1.0F, 1.0F});
}

}  // namespace

void draw_model_panel(Ui& ui, Workspace& work, ModelBench& model_bench) {
    draw_views(ui, model_bench);
    if (model_bench.panel.view == ModelView::training) return draw_training(ui, work, model_bench);
    const Model original;
    ImGui::BeginChild("parameters", ImGui::GetContentRegionAvail());
    draw_hint(ui, "model",
              "Every number here changes the prediction at once, for this set only. Changed ones "
              "show what they were; click it to go back.");
    draw_model_choice(ui, work, model_bench);
    draw_summary(ui, work, original);
    draw_heading(ui, "Trained in the paper",
                 "With the authors' own tables and kernels; with ours they are a starting point.");
    for (const NumberRow& row : kTrained) draw_number(ui, work, row, original);
    draw_heading(ui, "Choices of ours", "Where the paper leaves a choice open.");
    for (const ChoiceRow& row : kChoices) draw_choice(ui, work, row, original);
    for (const NumberRow& row : kNumbers) draw_number(ui, work, row, original);
    draw_heading(ui, "Physiology tables",
                 "Rebuilt from published rates and slopes; the original figures were not at hand.");
    draw_table_fields(ui, work, model_bench, original.coding.tables);
    ImGui::EndChild();
}

}  // namespace tact
