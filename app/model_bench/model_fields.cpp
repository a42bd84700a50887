#include "app/model_bench/model_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/model_bench/parts.h"
#include "app/ui/widgets.h"
#include "model/pattern/felt_steps.h"
#include "model/text/numbers.h"
#include "model/text/typed_number.h"
#include "viz/drawing/marks.h"

namespace tact {

// The least change of each number that people are taken to feel, with its source.

namespace {

// How a step is written: decibels of an amplitude, percent of a ratio, or the number's own unit.
struct FeltStepWords {
    const char* format;
    Range slider;
    double (*shown)(double size);
    double (*size)(double shown);
};

FeltStepWords words_of_step(PatternParameter parameter) {
    if (parameter == PatternParameter::amplitude) {
        return {"%.3g dB",
                {0.5, 6.0},
                [](double size) { return 20.0 * std::log10(size); },
                [](double db) { return std::pow(10.0, db / 20.0); }};
    }
    if (traits(parameter).by_ratio) {
        return {"%.3g %%",
                {2.0, 100.0},
                [](double size) { return 100.0 * (size - 1.0); },
                [](double percent) { return 1.0 + percent / 100.0; }};
    }
    const auto same = [](double value) { return value; };
    const bool is_time = *traits(parameter).unit != '\0';
    return {is_time ? "%.3g s" : "%.3g", {0.01, is_time ? 0.2 : 1.0}, same, same};
}

std::string source_text(PatternParameter parameter) {
    const ParameterTraits& about = traits(parameter);
    return std::string(about.step_is_guess ? "Guess: " : "Source: ") + about.step_source;
}

}  // namespace

void draw_felt_step_fields(Ui& ui, Workspace& work) {
    const FeltSteps usual;
    for (std::size_t k = 0; k < kPatternParameters.size(); ++k) {
        const PatternParameter parameter = kPatternParameters[k];
        const FeltStepWords words = words_of_step(parameter);
        const std::string id = std::string("felt_step_") + traits(parameter).key;
        const std::string help =
            "The least change that people are taken to feel. " + source_text(parameter);
        const Range sizes = step_range(parameter);
        double shown = words.shown(work.document.set.felt_steps.size[k]);
        const FieldEdit edit =
            draw_field(ui,
                       {.id = id.c_str(),
                        .label = traits(parameter).name,
                        .format = words.format,
                        .slider = words.slider,
                        .typed = {words.shown(sizes.low), words.shown(sizes.high)},
                        .step = words.slider.low,
                        .help = help.c_str(),
                        .right_room_px = beside_field_px(ui),
                        .normal = words.shown(usual.size[k])},
                       shown);
        if (edit.changed) {
            work.document.edit().felt_steps.size[k] = words.size(shown);
            document_changed(work);
        }
        if (edit.finished) {
            commit_step(ui, work, std::string("Change felt step of ") + traits(parameter).name);
        }
        ImGui::PushFont(ui.theme.fonts.small);
        draw_label(ui, "", 200.0F * ui.theme.scale);
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, source_text(parameter));
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
}

// The tables of slopes and thresholds of one receptor type, knot by knot.

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
    if (link_beside_field(
            ui, {.id = "reset:" + id, .label = shown_number(field.format, original.value[k])})) {
        write(original.value[k]);
        commit_step(ui, work, step);
    }
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
    if (link(ui, {.id = "load tables",
                  .label = "Load tables from CSV\u2026",
                  .tip = "A file with columns receptor, frequency_hz and either "
                         "slope_imp_per_s_per_log10um or threshold_log10_um_peak"})) {
        load_tables_dialog(ui, work);
    }
    if (curve == known) return;
    constexpr const char* kReset = "This table as it was";
    flow_on(ImGui::CalcTextSize(kReset).x, ui.theme.padding_px);
    if (link(ui, {.id = "reset:table", .label = kReset})) {
        curve_of(work.document.edit().model.coding.tables, state.threshold, state.type) = known;
        model_changed(work);
        commit_step(ui, work, std::string("Reset ") + traits(state.type).name + " table");
    }
}

// Threshold shifts of the four types, removing one, and presets.

namespace {

PerReceptor<Curve>& thresholds_of(Workspace& work) {
    return work.document.edit().model.coding.tables.threshold;
}

void set_threshold(Ui& ui, Workspace& work, Receptor type, const Curve& curve, const char* step) {
    thresholds_of(work)[index_of(type)] = curve;
    model_changed(work);
    commit_step(ui, work, std::string(step) + " " + traits(type).name);
}

void draw_removal(Ui& ui, Workspace& work, Receptor type, const Curve& original) {
    const bool gone = is_removed(thresholds_of(work)[index_of(type)]);
    if (link_beside_field(
            ui, {.id = std::string("remove:") + traits(type).afferent,
                 .label = gone ? "bring back" : "remove",
                 .tip = gone ? "Its threshold as it was" : "A type that answers to nothing",
                 .value = gone ? "removed" : ""})) {
        set_threshold(ui, work, type, gone ? original : removed(original),
                      gone ? "Bring back" : "Remove");
    }
}

void draw_shift(Ui& ui, Workspace& work, Receptor type, const Curve& original) {
    const Curve& curve = thresholds_of(work)[index_of(type)];
    const std::string id = std::string("shift_") + traits(type).afferent;
    const Field field{.id = id.c_str(),
                      .label = traits(type).name,
                      .format = "%+.1f dB",
                      .slider = kThresholdShiftDb,
                      .typed = kThresholdShiftDb,
                      .step = 1.0,
                      .snap = 0.5,
                      .help = "How much more it takes to be noticed, dB of displacement",
                      .enabled = !is_removed(curve),
                      .right_room_px = beside_field_px(ui),
                      .normal = 0.0};
    double db = is_removed(curve) ? 0.0 : shift_db(curve, original).value_or(0.0);
    ImGui::BeginGroup();
    const FieldEdit edit = draw_field(ui, field, db);
    ImGui::EndGroup();
    if (edit.changed) {
        thresholds_of(work)[index_of(type)] = shifted(curve, original, db);
        model_changed(work);
    }
    if (edit.finished)
        commit_step(ui, work, std::string("Shift threshold of ") + traits(type).name);
    draw_removal(ui, work, type, original);
}

void draw_presets(Ui& ui, Workspace& work, const PerReceptor<Curve>& original) {
    bool first = true;
    for (const ThresholdPreset& preset : kThresholdPresets) {
        const Item item{.id = std::string("preset:") + preset.name,
                        .label = std::string(preset.name) + " (guess)",
                        .tip = preset.words};
        if (!first) flow_on(ImGui::CalcTextSize(item.label.c_str()).x, ui.theme.padding_px);
        first = false;
        if (link(ui, item)) {
            for (const Receptor type : kReceptors) {
                const std::size_t c = index_of(type);
                thresholds_of(work)[c] = shifted(original[c], original[c], preset.db[c]);
            }
            model_changed(work);
            commit_step(ui, work, item.label);
        }
    }
}

}  // namespace

void draw_threshold_knobs(Ui& ui, Workspace& work, const PerReceptor<Curve>& original) {
    for (const Receptor type : kReceptors) draw_shift(ui, work, type, original[index_of(type)]);
    draw_presets(ui, work, original);
}

namespace {

// What the tables may hold at most.
constexpr double kNothingLog10Um = 6.0;
constexpr double kDbPerLog10 = 20.0;

}  // namespace

std::optional<double> shift_db(const Curve& curve, const Curve& original) {
    if (curve.frequency_hz != original.frequency_hz || curve.value.empty()) return std::nullopt;
    const double first = curve.value[0] - original.value[0];
    for (std::size_t k = 1; k < curve.value.size(); ++k) {
        if (std::abs(curve.value[k] - original.value[k] - first) > 1e-9) return std::nullopt;
    }
    return kDbPerLog10 * first;
}

Curve shifted(const Curve& curve, const Curve& original, double db) {
    const Curve& from = shift_db(curve, original) ? original : curve;
    Curve result = from;
    for (double& value : result.value) {
        value = std::min(value + db / kDbPerLog10, kNothingLog10Um);
    }
    return db == 0.0 ? from : result;
}

Curve removed(const Curve& original) {
    Curve result = original;
    std::ranges::fill(result.value, kNothingLog10Um);
    return result;
}

bool is_removed(const Curve& curve) {
    return std::ranges::all_of(curve.value, [](double v) { return v >= kNothingLog10Um; });
}

}  // namespace tact
