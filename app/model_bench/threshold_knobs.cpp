// Threshold shifts of the four types, removing one, and presets.

#include <string>

#include "app/document/editing.h"
#include "app/model_bench/model_panel.h"
#include "app/model_bench/threshold_shift.h"
#include "app/ui/widgets.h"

namespace tact {

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
    if (link_beside_field(ui, "remove", traits(type).afferent, gone ? "bring back" : "remove")) {
        set_threshold(ui, work, type, gone ? original : removed(original),
                      gone ? "Bring back" : "Remove");
    }
    note_item(ui.rects, std::string("remove:") + traits(type).afferent, gone ? "removed" : "");
    draw_tooltip(ui, gone ? "Its threshold as it was" : "A type that answers to nothing");
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
        const std::string text = std::string(preset.name) + " (guess)";
        if (!first) flow_on(ImGui::CalcTextSize(text.c_str()).x, ui.theme.padding_px);
        first = false;
        if (link(ui, preset.name, text)) {
            for (const Receptor type : kReceptors) {
                const std::size_t c = index_of(type);
                thresholds_of(work)[c] = shifted(original[c], original[c], preset.db[c]);
            }
            model_changed(work);
            commit_step(ui, work, text);
        }
        note_item(ui.rects, std::string("preset:") + preset.name);
        draw_tooltip(ui, preset.words);
    }
}

}  // namespace

void draw_threshold_knobs(Ui& ui, Workspace& work, const PerReceptor<Curve>& original) {
    for (const Receptor type : kReceptors) draw_shift(ui, work, type, original[index_of(type)]);
    draw_presets(ui, work, original);
}

}  // namespace tact
