#include "app/model_bench/kept_models.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/model_bench/training_state.h"
#include "app/session/folders.h"
#include "app/ui/file_question.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

fs::path model_folder(const App& app) {
    return app.session.folder.empty() ? fs::path{} : app.session.folder / "models";
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

std::string file_stem_of(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\\' || c == ':'; }, '-');
    return name.empty() ? "trained" : name;
}

Expected<Done> keep_model(App& app, const std::string& name, const ModelFile& content) {
    const fs::path folder = model_folder(app);
    if (folder.empty()) return Done{};
    const auto is_same = [&](const KeptModel& one) {
        return one.content.model == content.model && same_source(one.content, content);
    };
    if (std::ranges::any_of(kept_models(app), is_same)) return Done{};
    if (const auto made = make_folder(folder); !made) return made;
    const std::string stem = file_stem_of(name);
    fs::path file = folder / (stem + kModelEnding);
    std::error_code none;
    for (int k = 2; fs::exists(file, none); ++k) {
        file = folder / (stem + " " + std::to_string(k) + kModelEnding);
    }
    if (const auto written = write_model_file(file, content); !written) return written;
    app.training->kept_were_read = false;
    return Done{};
}

const std::vector<KeptModel>& kept_models(App& app) {
    TrainingState& state = *app.training;
    if (state.kept_were_read) return state.kept;
    state.kept_were_read = true;
    state.kept.clear();
    std::error_code fault;
    for (fs::directory_iterator entry(model_folder(app), fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const fs::path file = entry->path();
        if (file.extension() != ".json") continue;
        auto content = read_model_file(file);
        if (!content) {
            complain(app, content.error().message);
            continue;
        }
        state.kept.push_back({name_of_kept(file), file, *std::move(content)});
    }
    std::ranges::sort(state.kept, {}, &KeptModel::name);
    return state.kept;
}

void use_model(App& app, const PerceptualModelParams& model, const std::string& what) {
    if (app.document.set.model == model) return say(app, "These parameters are in use already.");
    app.document.set.model = model;
    document_changed(app);
    commit_step(app, "Use " + what);
    say(app, "In use: " + what + ". Undo brings the others back.");
}

void load_model_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::load_model,
                  .use = ChooserUse::open,
                  .title = "Load parameters of the model",
                  .extensions = {".json"}},
                 app.document.path.parent_path());
}

void load_model(App& app, const fs::path& path) {
    const auto content = read_model_file(path);
    if (!content) return complain(app, content.error().message);
    const std::string name = name_of_kept(path);
    const auto kept = keep_model(app, name, *content);
    use_model(app, content->model, "the parameters " + name);
    if (!kept) complain(app, "In use, but not kept for other sets: " + kept.error().message);
}

}  // namespace tact
