// Which parameters the model has: the paper's, or ones that were trained and kept.

#include <algorithm>

#include "app/model_bench/kept_models.h"
#include "app/model_bench/model_panel.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

constexpr const char* kPublished = "As published";

const KeptModel* kept_as(Ui& ui, const Workspace& work, ModelBench& model_bench) {
    const auto& kept = kept_models(ui, work, model_bench);
    const auto same = [&](const KeptModel& one) {
        return one.content.model == work.document.set.model;
    };
    const auto found = std::ranges::find_if(kept, same);
    return found == kept.end() ? nullptr : &*found;
}

std::string shown_name(const KeptModel& model) {
    const bool synthetic = !remark_on_synthetic(model.content).empty();
    const bool says_so = model.name.find("synthetic") != std::string::npos;
    return model.name + (synthetic && !says_so ? ", synthetic ratings" : "");
}

void draw_list(Ui& ui, Workspace& work, ModelBench& model_bench, const KeptModel* current) {
    const bool is_published = work.document.set.model == PerceptualModelParams{};
    if (ImGui::Selectable(kPublished, is_published))
        use_model(ui, work, {}, "the paper's parameters");
    note_item(ui.rects, std::string("model option:") + kPublished);
    // By value: choosing one may read the folder again.
    const std::vector<KeptModel> kept = kept_models(ui, work, model_bench);
    for (const KeptModel& one : kept) {
        const bool is_current = current != nullptr && current->file == one.file;
        ImGui::PushID(one.file.c_str());
        if (ImGui::Selectable(label_of(shown_name(one)).c_str(), is_current)) {
            use_model(ui, work, one.content, words_on(one.name, one.content));
        }
        ImGui::PopID();
        note_item(ui.rects, "model option:" + one.name, shown_name(one));
        draw_tooltip(ui, one.file.c_str());
    }
    draw_divider(ui.theme);
    if (ImGui::Selectable("Load parameters...")) load_model_dialog(ui, work);
    note_item(ui.rects, "model option:load");
}

}  // namespace

void draw_model_choice(Ui& ui, Workspace& work, ModelBench& model_bench) {
    const KeptModel* current = kept_as(ui, work, model_bench);
    const bool is_published = work.document.set.model == PerceptualModelParams{};
    const ModelOrigin origin = is_published         ? ModelOrigin{}
                               : current != nullptr ? origin_of(current->content)
                                                    : work.document.set.model_origin;
    const bool is_as_trained = !origin.trained_on.empty() && !origin.changed_by_hand;
    const std::string shown = is_published         ? kPublished
                              : current != nullptr ? shown_name(*current)
                              : is_as_trained      ? "As this set came"
                                                   : "Changed by hand";
    draw_label(ui, "Model", 160.0F * ui.theme.scale);
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::SetNextItemWidth(
        std::max(room - beside_field_px(ui), std::min(room, 120.0F * ui.theme.scale)));
    const bool open = ImGui::BeginCombo("##model", label_of(shown).c_str());
    if (open) {
        draw_list(ui, work, model_bench, current);
        ImGui::EndCombo();
    }
    note_item(ui.rects, "model:choice", shown);
    if (!open)
        draw_tooltip(ui, "Parameters for this set: the paper's, or kept ones that you trained.");
    if (origin.trained_on.empty()) return;
    ImGui::PushFont(ui.theme.fonts.small);
    const std::string provenance =
        origin.trained_on + (origin.changed_by_hand ? " Changed by hand since." : "");
    coloured_text(ui.theme.dim_text, provenance);
    ImGui::PopFont();
    note_item(ui.rects, "model:provenance", provenance);
    if (!origin.synthetic) return;
    const std::string remark = remark_on_synthetic(origin);
    coloured_text(ui.theme.warning, "These parameters were " + remark + ".");
    note_item(ui.rects, "model:synthetic", remark);
}

}  // namespace tact
