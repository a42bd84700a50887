#include "app/model_bench/model_bench.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/model_bench/parts.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/names.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

fs::path model_folder(const Workspace& work) {
    return work.session.folder.empty() ? fs::path{} : work.session.folder / "models";
}

// Trained on the same, at whatever time.
bool same_source(const ModelFile& a, const ModelFile& b) {
    if (!a.training || !b.training) return a.training == b.training;
    return a.training->sets == b.training->sets && a.training->objective == b.training->objective;
}

std::string name_of_kept(const fs::path& file) {
    std::string name = file.filename().string();
    for (const std::string ending : {kModelEnding, ".json"}) {
        if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
    }
    return name;
}

}  // namespace

Expected<Done> keep_model(Ui& ui, const Workspace& work, ModelBench& model_bench,
                          const std::string& name, const ModelFile& content) {
    const fs::path folder = model_folder(work);
    if (folder.empty()) return Done{};
    const auto is_same = [&](const KeptModel& one) {
        return one.content.model == content.model && same_source(one.content, content);
    };
    if (std::ranges::any_of(kept_models(ui, work, model_bench), is_same)) return Done{};
    if (const auto made = make_folder(folder); !made) return made;
    const std::string stem = file_stem(name.empty() ? "trained" : name);
    fs::path file = folder / (stem + kModelEnding);
    std::error_code none;
    for (int k = 2; fs::exists(file, none); ++k) {
        file = folder / (stem + " " + std::to_string(k) + kModelEnding);
    }
    if (const auto written = write_model_file(file, content); !written) return written;
    model_bench.training.kept_were_read = false;
    return Done{};
}

const std::vector<KeptModel>& kept_models(Ui& ui, const Workspace& work, ModelBench& model_bench) {
    TrainingState& state = model_bench.training;
    if (state.kept_were_read) return state.kept;
    state.kept_were_read = true;
    state.kept.clear();
    std::error_code fault;
    for (fs::directory_iterator entry(model_folder(work), fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path file = entry->path();
        if (file.extension() != ".json") continue;
        auto content = read_model_file(file);
        if (!content) {
            complain(ui, content.error().message);
            continue;
        }
        state.kept.push_back({name_of_kept(file), file, *std::move(content)});
    }
    std::ranges::sort(state.kept, {}, &KeptModel::name);
    return state.kept;
}

void use_model(Ui& ui, Workspace& work, const ModelFile& content, const std::string& what) {
    PatternSet& set = work.document.edit();
    const ModelOrigin origin = origin_of(content);
    if (set.model == content.model && set.model_origin == origin) {
        return say(ui, "These parameters are in use already.");
    }
    set.model = content.model;
    set.model_origin = origin;
    document_changed(work);
    commit_step(ui, work, "Use " + what);
    say(ui, "In use: " + what + ". Undo brings the others back.");
}

std::string words_on(const std::string& name, const ModelFile& content) {
    const std::string remark = remark_on_synthetic(content);
    return "the parameters " + name + (remark.empty() ? "" : ", " + remark);
}

void load_model_dialog(Ui& ui, Workspace& work, ModelBench& model_bench) {
    ask_for_file(ui,
                 {.use = ChooserUse::open,
                  .title = "Load parameters of the model",
                  .extensions = {".json"},
                  .take = [&](const fs::path& file) { load_model(ui, work, model_bench, file); }},
                 work.document.path.parent_path());
}

void load_model(Ui& ui, Workspace& work, ModelBench& model_bench, const fs::path& path) {
    const auto content = read_model_file(path);
    if (!content) return complain(ui, content.error().message);
    const std::string name = name_of_kept(path);
    const auto kept = keep_model(ui, work, model_bench, name, *content);
    use_model(ui, work, *content, words_on(name, *content));
    if (!kept) complain(ui, "In use, but not kept for other sets: " + kept.error().message);
}

// Which parameters the model has: the paper's, or ones that were trained and kept.

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
    if (option(ui, {.id = std::string("model option:") + kPublished, .label = kPublished},
               is_published)) {
        use_model(ui, work, {}, "the paper's parameters");
    }
    // By value: choosing one may read the folder again.
    const std::vector<KeptModel> kept = kept_models(ui, work, model_bench);
    for (const KeptModel& one : kept) {
        const bool is_current = current != nullptr && current->file == one.file;
        ImGui::PushID(one.file.c_str());
        if (option(ui,
                   {.id = "model option:" + one.name,
                    .label = shown_name(one),
                    .tip = one.file.string()},
                   is_current)) {
            use_model(ui, work, one.content, words_on(one.name, one.content));
        }
        ImGui::PopID();
    }
    draw_divider(ui.theme);
    if (option(ui, {.id = "model option:load", .label = "Load parameters..."}, false))
        load_model_dialog(ui, work, model_bench);
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
    drop_down(
        ui,
        {.id = "model:choice",
         .label = shown,
         .tip = "Parameters for this set: the paper's, or kept ones that you trained."},
        std::max(room - beside_field_px(ui), std::min(room, 120.0F * ui.theme.scale)),
        [&] { draw_list(ui, work, model_bench, current); }, ImGuiComboFlags_HeightRegular);
    if (origin.trained_on.empty()) return;
    ImGui::PushFont(ui.theme.fonts.small);
    const std::string provenance =
        origin.trained_on + (origin.changed_by_hand ? " Changed by hand since." : "");
    coloured_text(ui, ui.theme.dim_text, {.id = "model:provenance", .text = provenance});
    ImGui::PopFont();
    if (!origin.synthetic) return;
    const std::string remark = remark_on_synthetic(origin);
    coloured_text(ui, ui.theme.warning,
                  {.id = "model:synthetic",
                   .text = "These parameters were " + remark + ".",
                   .value = remark});
}

}  // namespace tact
