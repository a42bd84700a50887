// Models that were used are kept with their provenance in the folder "models" beside the session,
// for choosing in any set.
//
// Left out  removing one: its file is the person's to delete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/model_bench/model_state.h"
#include "app/model_bench/training_state.h"
#include "app/ui/ui.h"
#include "model/io/set/model_file.h"

namespace tact {

inline constexpr const char* kModelEnding = ".model.json";

// Read once, by name; empty without a folder to keep them in.
const std::vector<KeptModel>& kept_models(Ui& ui, const Workspace& work, ModelBench& model_bench);

// Under a name that no other has; one that is there already stays. An Error changes nothing.
Expected<Done> keep_model(Ui& ui, const Workspace& work, ModelBench& model_bench,
                          const std::string& name, const ModelFile& content);

// The document's model, as one step. `what`: "the paper's parameters".
void use_model(Ui& ui, Workspace& work, const ModelFile& content, const std::string& what);

// What is said of a kept model when it comes into use: its name, and that nobody was asked.
std::string words_on(const std::string& name, const ModelFile& content);

// From a file, to be kept and used.
void load_model_dialog(Ui& ui, const Workspace& work);
void load_model(Ui& ui, Workspace& work, ModelBench& model_bench,
                const std::filesystem::path& path);

}  // namespace tact
