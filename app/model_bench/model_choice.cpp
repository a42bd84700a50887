// Which parameters the model has: the paper's, or ones that were trained and kept.

#include <algorithm>

#include "app/model_bench/kept_models.h"
#include "app/model_bench/model_panel.h"
#include "app/model_bench/trained_text.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

constexpr const char* kPublished = "As published";

const KeptModel* kept_as(App& app) {
    const auto& kept = kept_models(app);
    const auto same = [&](const KeptModel& one) {
        return one.content.model == app.document.set.model;
    };
    const auto found = std::ranges::find_if(kept, same);
    return found == kept.end() ? nullptr : &*found;
}

void draw_list(App& app, const KeptModel* current) {
    const bool is_published = app.document.set.model == PerceptualModelParams{};
    if (ImGui::Selectable(kPublished, is_published)) use_model(app, {}, "the paper's parameters");
    note_item(app.rects, std::string("model option:") + kPublished);
    // By value: choosing one may read the folder anew.
    const std::vector<KeptModel> kept = kept_models(app);
    for (const KeptModel& one : kept) {
        const bool is_current = current != nullptr && current->file == one.file;
        ImGui::PushID(one.file.c_str());
        if (ImGui::Selectable(one.name.c_str(), is_current)) {
            use_model(app, one.content.model, "the parameters " + one.name);
        }
        ImGui::PopID();
        note_item(app.rects, "model option:" + one.name);
        draw_tooltip(app, one.file.c_str());
    }
    ImGui::Separator();
    if (ImGui::Selectable("Load parameters...")) load_model_dialog(app);
    note_item(app.rects, "model option:load");
}

}  // namespace

void draw_model_choice(App& app) {
    const KeptModel* current = kept_as(app);
    const bool is_published = app.document.set.model == PerceptualModelParams{};
    const std::string shown = is_published         ? kPublished
                              : current != nullptr ? current->name
                                                   : "Changed by hand";
    std::string provenance;
    if (!is_published && current != nullptr && current->content.training) {
        provenance = provenance_text(*current->content.training);
    }
    draw_label(app, "Model", 160.0F * app.theme.scale);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool open = ImGui::BeginCombo("##model", shown.c_str());
    if (open) {
        draw_list(app, current);
        ImGui::EndCombo();
    }
    note_item(app.rects, "model:choice", shown);
    if (!open)
        draw_tooltip(app, "Parameters for this set: the paper's, or kept ones that you trained.");
    if (provenance.empty()) return;
    ImGui::PushFont(app.theme.fonts.small);
    coloured_text(app.theme.dim_text, provenance);
    ImGui::PopFont();
    note_item(app.rects, "model:provenance", provenance);
}

}  // namespace tact
