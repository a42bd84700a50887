// The tables of slopes and thresholds of one receptor type, knot by knot.

#include <array>
#include <cmath>
#include <vector>

#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/model_bench/model_panel.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/typed_number.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr Range kThresholdLog10Um{-6.0, 6.0};
constexpr Range kSlope{0.0, 10'000.0};

Curve& curve_of(PhysiologyTables& tables, bool threshold, Receptor type) {
    return threshold ? tables.threshold[index_of(type)] : tables.slope[index_of(type)];
}

const Curve& curve_of(const PhysiologyTables& tables, bool threshold, Receptor type) {
    return threshold ? tables.threshold[index_of(type)] : tables.slope[index_of(type)];
}

void draw_choices(Ui& ui, ModelBench& model_bench) {
    ModelPanelState& state = model_bench.panel;
    std::vector<Choice<Receptor>> receptors;
    for (const Receptor receptor : kReceptors)
        receptors.push_back({receptor, traits(receptor).name});
    draw_segments(ui, receptors, state.type, "table:");
    constexpr std::array kTables{Choice{true, "threshold"}, Choice{false, "slope"}};
    draw_segments(ui, kTables, state.threshold, "table:");
    // Behind each number it would be cut in a narrow pane.
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, state.threshold ? "log10 of \u00b5m peak" : "impulses/s per log10 of \u00b5m");
    ImGui::PopTextWrapPos();
}

// One knot: its frequency, its value, and what it was.
void draw_knot(Ui& ui, Workspace& work, const ModelBench& model_bench, std::size_t k,
               const Curve& original) {
    const ModelPanelState& state = model_bench.panel;
    const Curve& curve =
        curve_of(work.document.set.model.coding.tables, state.threshold, state.type);
    const std::string label = significant_digits(curve.frequency_hz[k], 4) + " Hz";
    const std::string id = "knot_" + std::to_string(k);
    Field field{.id = id.c_str(),
                .label = label.c_str(),
                .format = state.threshold ? "%.3f" : "%.4g",
                .slider = state.threshold ? Range{-3.0, 4.0} : Range{0.0, 400.0},
                .typed = state.threshold ? kThresholdLog10Um : kSlope,
                .step = state.threshold ? 0.05 : 1.0,
                .help = state.threshold ? "Absolute threshold, log10 of \u00b5m peak: 1 is 10 "
                                          "\u00b5m, or 20 dB re 1 \u00b5m"
                                        : "Slope \u03b1, impulses/s per log10 of \u00b5m",
                .right_room_px = beside_field_px(ui)};
    const bool known = k < original.value.size() && curve.frequency_hz == original.frequency_hz;
    if (known) field.normal = original.value[k];
    double value = curve.value[k];
    const double before = value;
    ImGui::BeginGroup();
    const FieldEdit edit = draw_field(ui, field, value);
    ImGui::EndGroup();
    const auto write = [&](double to) {
        PhysiologyTables& tables = work.document.edit().model.coding.tables;
        curve_of(tables, state.threshold, state.type).value[k] = to;
        model_changed(work);
    };
    const std::string step = std::string("Change ") + traits(state.type).name +
                             (state.threshold ? " threshold" : " slope");
    if (edit.changed) write(value);
    if (edit.finished) commit_step(ui, work, step);
    if (!known || before == original.value[k]) return;
    const std::string text = shown_number(field.format, original.value[k]);
    if (link_beside_field(ui, "back", id, text.c_str())) {
        write(original.value[k]);
        commit_step(ui, work, step);
    }
    note_item(ui.rects, "reset:" + id);
}

}  // namespace

void draw_table_fields(Ui& ui, Workspace& work, ModelBench& model_bench,
                       const PhysiologyTables& original) {
    draw_choices(ui, model_bench);
    const ModelPanelState& state = model_bench.panel;
    const Curve curve =
        curve_of(work.document.set.model.coding.tables, state.threshold, state.type);
    const Curve& known = curve_of(original, state.threshold, state.type);
    for (std::size_t k = 0; k < curve.value.size(); ++k) draw_knot(ui, work, model_bench, k, known);
    if (link(ui, "load tables", "Load tables from CSV\u2026")) load_tables_dialog(ui, work);
    note_item(ui.rects, "load tables");
    draw_tooltip(ui,
                 "A file with columns receptor, frequency_hz and either "
                 "slope_imp_per_s_per_log10um or threshold_log10_um_peak");
    if (curve == known) return;
    constexpr const char* kReset = "This table as it was";
    flow_on(ImGui::CalcTextSize(kReset).x, ui.theme.padding_px);
    if (link(ui, "reset table", kReset)) {
        curve_of(work.document.edit().model.coding.tables, state.threshold, state.type) = known;
        model_changed(work);
        commit_step(ui, work, std::string("Reset ") + traits(state.type).name + " table");
    }
    note_item(ui.rects, "reset:table");
}

}  // namespace tact
