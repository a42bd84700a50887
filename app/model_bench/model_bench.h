// Parameters of PM, training.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/tables/tables.h"
#include "app/ui/ui.h"
#include "model/io/set/model_file.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/mechanoreceptor.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"
#include "model/training/training.h"

namespace tact {

// Training in the model bench: what it is asked to fit to, and what it has found.

// A set with ratings that takes part, or could.
struct SetToFit {
    std::string set_name;    // as a record has it
    std::string shown_name;  // with what is to be said of its ratings
    std::shared_ptr<const PatternSet> set;
    std::shared_ptr<const RatingStudy> study;  // in the order of its patterns
    std::size_t people = 0;
    std::filesystem::path file;  // empty: the document
    bool takes_part = true;
};

struct TrainingRequest {
    std::vector<SetToFit> sets;
    PerceptualModelParams model;
    int units = 10;
    TrainingObjective objective = TrainingObjective::mean_rho;
    bool leave_out_participants = false;
};

struct FoundTraining {
    TrainingRequest request;
    std::string fault;  // why there is nothing to fit to; then there is no training
    Training training;
    TrainingRecord record;
};

// Parameters kept in the folder of models, or the paper's.
struct KeptModel {
    std::string name;
    std::filesystem::path file;
    ModelFile content;
};

// The document's part of the request, kept while the document stays.
struct OwnRatings {
    std::uint64_t revision = 0;  // of the document; 0: none known yet
    std::optional<SetToFit> set;
    std::string fault;  // why it is missing
};

// Whether the result is of the present sets that take part, kept while all of that stays.
struct TrainingFreshness {
    std::shared_ptr<const FoundTraining> of;
    std::uint64_t revision = 0;  // of the document
    std::vector<std::shared_ptr<const PatternSet>> sets;
    bool is_stale = false;
};

// What the search would cost, kept while the question stays.
struct TrainingEstimate {
    std::vector<std::size_t> patterns;  // of each set
    int units = 0;
    TrainingCost cost;
};

struct TrainingState {
    int units = 10;  // steps of a weight between 0 and 1
    TrainingObjective objective = TrainingObjective::mean_rho;
    bool leave_out_participants = false;
    bool own_takes_part = true;
    std::vector<SetToFit> others;  // from files
    bool shows_ties = false;
    bool scroll_to_result = false;  // it has just come

    OwnRatings own;
    TrainingFreshness freshness;
    TrainingEstimate estimate;
    std::vector<KeptModel> kept;  // by name
    bool kept_were_read = false;

    Query<TrainingRequest, FoundTraining> job;
    std::shared_ptr<const FoundTraining> found;
};

// Which part of the model the bench shows.

enum class ModelView { parameters, training };

// Which view of the model bench is shown, and whose knots it lists.
struct ModelPanelState {
    ModelView view = ModelView::parameters;
    Receptor type = Receptor::pacinian;
    bool threshold = true;  // or slope
};

struct ModelBench {
    ModelPanelState panel;
    TrainingState training;
};

// Models that were used are kept with their provenance in the folder "models" beside the session,
// for choosing in any set.
//
// Left out  removing one: its file is the person's to delete.

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
void load_model_dialog(Ui& ui, Workspace& work, ModelBench& model_bench);
void load_model(Ui& ui, Workspace& work, ModelBench& model_bench,
                const std::filesystem::path& path);

// The model bench: the parameters of PM, the knots of its tables, which parameters to have, and
// fitting them to ratings.

void draw_model_panel(Ui& ui, Workspace& work, TableState& table, ModelBench& model_bench);
// How deaf each receptor type is, as a whole.
void draw_threshold_knobs(Ui& ui, Workspace& work, const PerReceptor<Curve>& original);
void draw_table_fields(Ui& ui, Workspace& work, ModelBench& model_bench,
                       const PhysiologyTables& original);
void draw_model_choice(Ui& ui, Workspace& work, ModelBench& model_bench);
void draw_training(Ui& ui, Workspace& work, TableState& table, ModelBench& model_bench);

// Trained parameters and where they come from, in words: for the terminal and for the window.

// A weight of a grid whose steps are so long, with as many digits as that takes, at most three.
std::string weight_text(double weight, double step);

// In the order of kTrainedNames.
std::vector<std::string> parameter_texts(const PerceptualModelParams& model, double step);

// Texts of a class of equally good combinations: the smallest of its proportion, "any" for what
// does not matter as OC alone decides.
std::vector<std::string> parameter_texts(const TrainingGrid& grid, const GridPoint& point);

// Fitting the model's parameters to ratings from the window.

// Takes what the job has found.
void follow_training(Ui& ui, ModelBench& model_bench);
bool is_training(const ModelBench& model_bench);

// The document's ratings as a set to train on; where it has none that fit, why.
const OwnRatings& own_ratings(const Workspace& work, ModelBench& model_bench);

// All sets that take part, the document first.
TrainingRequest training_request(const Workspace& work, ModelBench& model_bench);
void begin_training(const Ui& ui, const Workspace& work, ModelBench& model_bench);
void cancel_training(ModelBench& model_bench);

// Whether the patterns, the ratings or the model's other choices have changed since.
bool is_training_stale(const Workspace& work, ModelBench& model_bench);

// Sets with ratings of their own, from files.
void add_training_set_dialog(Ui& ui, const Workspace& work, ModelBench& model_bench);
void add_training_set(Ui& ui, const Workspace& work, ModelBench& model_bench,
                      const std::filesystem::path& path);

// What was found becomes the document's model, as one step, and is kept.
void use_trained(Ui& ui, Workspace& work, ModelBench& model_bench);
void save_trained_dialog(Ui& ui, const Workspace& work, const ModelBench& model_bench);
void save_trained(Ui& ui, const ModelBench& model_bench, const std::filesystem::path& path);

}  // namespace tact
