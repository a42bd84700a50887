// The model bench: every parameter of PM, what the paper gives, what is ours, and what was changed.

#include <algorithm>
#include <array>
#include <functional>

#include "app/document/editing.h"
#include "app/model_bench/model_bench.h"
#include "app/model_bench/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/typed_number.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using Model = PerceptualModelParams;

void change_model(Workspace& work, const std::function<void(Model&)>& change) {
    change(work.document.edit().model);
    model_changed(work);
}

void commit_model(Ui& ui, Workspace& work, const std::string& what) {
    commit_step(ui, work, "Change " + what);
}

constexpr const char* kWayBackHelp = "Changed. Click to go back to this value.";

// After a row that was changed: what it was, and the way back. True when pressed.
bool draw_way_back(Ui& ui, const char* id, bool changed, const std::string& original) {
    if (!changed) return false;
    flow_on(ImGui::CalcTextSize(original.c_str()).x, ui.theme.gap_px * 0.5F);
    return row_link(ui, {.id = std::string("reset:") + id, .label = original, .tip = kWayBackHelp});
}

void draw_number(Ui& ui, Workspace& work, const ModelNumber& row, const Model& original) {
    const double before = row.get(work.document.set.model);
    const double known = row.get(original);
    double value = before;
    ImGui::BeginGroup();
    Field field = row.field;
    field.right_room_px = beside_field_px(ui);
    field.normal = known;
    const FieldEdit edit = draw_field(ui, field, value);
    ImGui::EndGroup();
    if (edit.changed) change_model(work, [&](Model& m) { row.set(m, value); });
    if (edit.finished) commit_model(ui, work, row.field.label);
    if (before == known) return;
    if (link_beside_field(ui, {.id = std::string("reset:") + row.field.id,
                               .label = shown_number(row.field.format, known),
                               .tip = kWayBackHelp})) {
        change_model(work, [&](Model& m) { row.set(m, known); });
        commit_model(ui, work, row.field.label);
    }
}

void draw_choice(Ui& ui, Workspace& work, const ModelChoice& row, const Model& original) {
    const int before = row.get(work.document.set.model);
    const int known = row.get(original);
    ImGui::PushID(row.id);
    const std::array options{Choice{0, row.options[0], row.help},
                             Choice{1, row.options[1], row.help}};
    draw_label(ui, row.label, segments_width(ui, options));
    draw_tooltip(ui, row.help);
    int chosen = before;
    if (draw_segments(ui, options, chosen, std::string("choice:") + row.id + " ")) {
        change_model(work, [&](Model& m) { row.set(m, chosen); });
        commit_model(ui, work, row.label);
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

// How many controls are not as they come: the choice of thresholds is one, and not four tables.
int count_changed(const Model& model, const Model& original) {
    int count = 0;
    Model chosen = original;
    for (const ModelChoice& row : choice_rows()) {
        if (row.get(model) < static_cast<int>(row.options.size())) row.set(chosen, row.get(model));
    }
    for (const ModelNumber& row : trained_rows()) count += row.get(model) != row.get(original);
    for (const ModelNumber& row : number_rows()) count += row.get(model) != row.get(original);
    for (const ModelChoice& row : choice_rows()) count += row.get(chosen) != row.get(original);
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        count += model.coding.tables.slope[c] != original.coding.tables.slope[c];
        count += model.coding.tables.threshold[c] != chosen.coding.tables.threshold[c];
    }
    return count;
}

void draw_summary(Ui& ui, Workspace& work, const Model& original) {
    constexpr const char* kAsPublished =
        "As published: trained parameters of the paper, choices of ours where it leaves one open.";
    const float width_px = ImGui::GetContentRegionAvail().x;
    const float below_px = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y +
                           ImGui::CalcTextSize(kAsPublished, nullptr, false, width_px).y;
    const int changed = count_changed(work.document.set.model, original);
    if (changed == 0) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, kAsPublished);
        ImGui::PopTextWrapPos();
        return;
    }
    const std::string text =
        counted(static_cast<std::size_t>(changed), "parameter", "parameters") + " changed.";
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    plain_text(ui, {.id = "model:changed", .text = text, .value = std::to_string(changed)});
    ImGui::PopStyleColor();
    constexpr const char* kBack = "Back to the paper's";
    flow_on(ImGui::CalcTextSize(kBack).x, ui.theme.gap_px);
    if (link(ui, {.id = "reset:model", .label = kBack})) {
        change_model(work, [&](Model& m) { m = original; });
        commit_model(ui, work, "the model back to the paper's");
    }
    // As high as the sentence: rows stay under the pointer at the first change.
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), below_px));
}

void draw_views(Ui& ui, ModelBench& model_bench) {
    const auto view = [&](ModelView which, const char* name) {
        const Item item{.id = std::string("model:") + name, .label = name};
        if (chip(ui, item, model_bench.panel.view == which)) model_bench.panel.view = which;
    };
    view(ModelView::parameters, "Parameters");
    flow_on(chip_width(ui, "Train on ratings"), 2.0F * ui.theme.scale);
    view(ModelView::training, "Train on ratings");
    ImGui::Dummy({1.0F, 1.0F});
}

}  // namespace

float beside_field_px(const Ui& ui) { return 84.0F * ui.theme.scale; }

bool link_beside_field(Ui& ui, const Item& item) {
    const ImVec2 end = ImGui::GetItemRectMax();
    ImGui::SetCursorScreenPos({end.x + 0.5F * ui.theme.gap_px, end.y - ImGui::GetFrameHeight()});
    return row_link(ui, item);
}

void draw_model_panel(Ui& ui, Workspace& work, TableState& table, ModelBench& model_bench) {
    draw_views(ui, model_bench);
    if (model_bench.panel.view == ModelView::training)
        return draw_training(ui, work, table, model_bench);
    const Model original;
    ImGui::BeginChild("parameters", ImGui::GetContentRegionAvail());
    draw_hint(ui, "model",
              "Every number here changes the prediction at once, for this set only. Changed ones "
              "show what they were; click it to go back.");
    draw_model_choice(ui, work, model_bench);
    draw_summary(ui, work, original);
    draw_heading(
        ui, "Trained in the paper",
        "Layers of excitation and inhibition, weights of the receptor types, of NC (neural "
        "coding) and OC (rhythm). With the authors' own tables and kernels; with ours they "
        "are a starting point.");
    for (const ModelNumber& row : trained_rows()) draw_number(ui, work, row, original);
    draw_heading(ui, "Choices of ours", "Where the paper leaves a choice open.");
    for (const ModelChoice& row : choice_rows()) draw_choice(ui, work, row, original);
    for (const ModelNumber& row : number_rows()) draw_number(ui, work, row, original);
    draw_heading(ui, "Thresholds",
                 "How much more it takes than in the table before a type notices anything.");
    draw_threshold_knobs(ui, work, original.coding.tables.threshold);
    draw_heading(ui, "Physiology tables",
                 "Rebuilt from published rates and slopes; the original figures were not at hand.");
    draw_table_fields(ui, work, model_bench, original.coding.tables);
    draw_heading(ui, "What people feel",
                 "The least felt step of each number: by these, changes are proposed and pairs are "
                 "too close. PM does not depend on them.");
    draw_felt_step_fields(ui, work);
    ImGui::EndChild();
}

}  // namespace tact
