#include "app/model_bench/kept_models.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/model_bench/training_state.h"
#include "app/session/folders.h"
#include "app/ui/file_question.h"
#include "model/text/file_stem.h"

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

void load_model_dialog(Ui& ui, const Workspace& work) {
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::load_model,
                  .use = ChooserUse::open,
                  .title = "Load parameters of the model",
                  .extensions = {".json"}},
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

}  // namespace tact
