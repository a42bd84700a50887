#include "app/model_bench/model_bench.h"

#include <algorithm>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/session/program_version.h"
#include "app/ui/ui.h"
#include "model/io/set/load.h"
#include "model/set/pattern_set.h"
#include "model/tasks/set_people.h"
#include "model/tasks/set_training.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// Results are told under the names of the list; the record has those of the sets.
void name_as_listed(FoundTraining& found) {
    for (std::size_t s = 0; s < found.request.sets.size(); ++s) {
        const std::string& name = found.request.sets[s].shown_name;
        found.training.sets[s].name = name;
        if (s < found.training.without_set.size()) found.training.without_set[s].name = name;
    }
}

std::optional<FoundTraining> find_parameters(const TrainingRequest& request, std::stop_token stop,
                                             std::atomic<float>& progress) {
    TrainRequest asked;
    for (const SetToFit& rated : request.sets) {
        asked.sets.push_back(training_set(rated.set_name, *rated.set, *rated.study));
    }
    asked.model = request.model;
    asked.units = request.units;
    asked.objective = request.objective;
    if (request.leave_out_participants) asked.leave_out = LeaveOut::participants;
    asked.program = kProgramVersion;
    asked.stop = stop;
    asked.progress = [&progress](double share) { progress = static_cast<float>(share); };
    FoundTraining found{request, {}, {}, {}};
    if (const auto fits = can_train(asked); !fits) {
        found.fault = fits.error().message;
        return found;
    }
    std::optional<Trained> trained = train(asked);
    if (!trained) return std::nullopt;
    found.training = std::move(trained->training);
    found.record = std::move(trained->record);
    name_as_listed(found);
    return found;
}

// `file`: the name of its file, which stands for one without a name.
Expected<SetToFit> rated_set(const PatternSet& set, const std::string& file) {
    Expected<Counted> people = set_people(set);
    if (!people) return people.error();
    SetToFit rated;
    rated.set_name = set.name.empty() ? file : set.name;
    rated.shown_name = rated.set_name;
    rated.set = std::make_shared<const PatternSet>(set);
    rated.people = participant_means(people->study).size();
    rated.study = std::make_shared<const RatingStudy>(std::move(people->study));
    if (const std::string words = words_of(mark_of(*rated.study)); !words.empty()) {
        rated.shown_name += ", " + words + " ratings";
    }
    return rated;
}

// What is trained aside, the same model.
bool same_choices(PerceptualModelParams a, const PerceptualModelParams& b) {
    a.coding.excitatory_layers = b.coding.excitatory_layers;
    a.coding.inhibitory_layers = b.coding.inhibitory_layers;
    a.channel_weight = b.channel_weight;
    a.nc_weight = b.nc_weight;
    a.oc_weight = b.oc_weight;
    return a == b;
}

// Which search it is: cheap to tell, in every frame.
bool is_another_search(const TrainingRequest& asked, const TrainingRequest& now) {
    return asked.units != now.units || asked.objective != now.objective ||
           asked.leave_out_participants != now.leave_out_participants;
}

bool differ(const TrainingRequest& asked, const TrainingRequest& now) {
    if (!same_choices(asked.model, now.model)) return true;
    return !std::ranges::equal(asked.sets, now.sets, [](const SetToFit& a, const SetToFit& b) {
        return a.file == b.file && (a.set == b.set || (a.set->vibrations == b.set->vibrations &&
                                                       a.set->ratings == b.set->ratings));
    });
}

std::string proposed_name(const FoundTraining& found) {
    return file_stem(found.request.sets.front().shown_name + " " + found.record.date.substr(0, 10));
}

}  // namespace

void follow_training(Ui& ui, ModelBench& model_bench) {
    TrainingState& state = model_bench.training;
    const auto latest = state.job.latest();
    if (!latest || latest == state.found) return;
    state.found = latest;
    state.scroll_to_result = latest->fault.empty();
    if (!latest->fault.empty()) complain(ui, "Nothing to fit to: " + latest->fault);
}

bool is_training(const ModelBench& model_bench) { return model_bench.training.job.busy(); }

const OwnRatings& own_ratings(const Workspace& work, ModelBench& model_bench) {
    OwnRatings& own = model_bench.training.own;
    if (own.revision == work.revision) return own;
    const PatternSet& set = work.document.set;
    const bool same = own.set && own.set->set->vibrations == set.vibrations &&
                      own.set->set->ratings == set.ratings && own.set->set->name == set.name;
    own.revision = work.revision;
    if (same) return own;
    own.set.reset();
    own.fault.clear();
    if (set.ratings.empty()) return own;
    const fs::path& path = work.document.path;
    auto rated = rated_set(set, path.empty() ? "the open set" : path.filename().string());
    if (rated) {
        own.set = *std::move(rated);
    } else {
        own.fault = rated.error().message;
    }
    return own;
}

TrainingRequest training_request(const Workspace& work, ModelBench& model_bench) {
    const TrainingState& state = model_bench.training;
    TrainingRequest request{
        {}, work.document.set.model, state.units, state.objective, state.leave_out_participants};
    const OwnRatings& own = own_ratings(work, model_bench);
    if (own.set && state.own_takes_part) request.sets.push_back(*own.set);
    std::ranges::copy_if(state.others, std::back_inserter(request.sets), &SetToFit::takes_part);
    return request;
}

void begin_training(const Ui& ui, const Workspace& work, ModelBench& model_bench) {
    TrainingRequest request = training_request(work, model_bench);
    if (request.sets.empty()) return;
    model_bench.training.job.ask(std::move(request), find_parameters, ui.wake);
}

void cancel_training(ModelBench& model_bench) { model_bench.training.job.cancel(); }

bool is_training_stale(const Workspace& work, ModelBench& model_bench) {
    TrainingFreshness& fresh = model_bench.training.freshness;
    const auto& found = model_bench.training.found;
    if (!found) return false;
    const TrainingRequest now = training_request(work, model_bench);
    std::vector<std::shared_ptr<const PatternSet>> sets;
    for (const SetToFit& rated : now.sets) sets.push_back(rated.set);
    const bool is_known =
        fresh.of == found && fresh.revision == work.revision && fresh.sets == sets;
    if (!is_known) fresh = {found, work.revision, sets, differ(found->request, now)};
    return fresh.is_stale || is_another_search(found->request, now);
}

void add_training_set_dialog(Ui& ui, const Workspace& work, ModelBench& model_bench) {
    ask_for_file(
        ui,
        {.use = ChooserUse::open,
         .title = "Add a set that has ratings",
         .extensions = {".json"},
         .take = [&](const fs::path& file) { add_training_set(ui, work, model_bench, file); }},
        work.document.path.parent_path());
}

void add_training_set(Ui& ui, const Workspace& work, ModelBench& model_bench,
                      const fs::path& path) {
    const std::string file = path.filename().string();
    const auto taken = [&](const SetToFit& one) { return one.file == path; };
    if (path == work.document.path || std::ranges::any_of(model_bench.training.others, taken)) {
        return complain(ui, file + " takes part already.");
    }
    const auto loaded = load_set(path);
    if (!loaded) return complain(ui, loaded.error().message);
    auto rated = rated_set(loaded->set, file);
    if (!rated) {
        return complain(ui, file + ": " + rated.error().message +
                                "; open it and load its ratings, then save it");
    }
    rated->file = path;
    model_bench.training.others.push_back(*std::move(rated));
    say(ui, file + " takes part in training.");
}

void use_trained(Ui& ui, Workspace& work, ModelBench& model_bench) {
    const auto found = model_bench.training.found;  // kept while its list is read again
    if (!found || !found->fault.empty()) return;
    const ModelFile content{found->training.model, found->record};
    const auto kept = keep_model(ui, work, model_bench, proposed_name(*found), content);
    const std::string remark = remark_on_synthetic(content);
    use_model(ui, work, content, "the trained parameters" + (remark.empty() ? "" : ", " + remark));
    if (!kept) complain(ui, "In use, but not kept for other sets: " + kept.error().message);
}

void save_trained_dialog(Ui& ui, const Workspace& work, const ModelBench& model_bench) {
    if (!model_bench.training.found) return;
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Save the trained parameters",
                  .extensions = {".json"},
                  .take = [&](const fs::path& file) { save_trained(ui, model_bench, file); }},
                 work.document.path.parent_path(),
                 proposed_name(*model_bench.training.found) + kModelEnding);
}

void save_trained(Ui& ui, const ModelBench& model_bench, const fs::path& path) {
    const auto& found = model_bench.training.found;
    if (!found) return;
    const auto written = write_model_file(path, {found->training.model, found->record});
    if (!written) return complain(ui, written.error().message);
    const std::string remark = remark_on_synthetic({found->training.model, found->record});
    say(ui, "Parameters" + (remark.empty() ? "" : " " + remark + ",") + " saved to " +
                path.string() + ", for --model on the command line too.");
}

}  // namespace tact
