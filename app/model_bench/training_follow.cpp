#include "app/model_bench/training_follow.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/model_bench/kept_models.h"
#include "app/session/program_version.h"
#include "app/ui/file_question.h"
#include "model/io/set/load.h"
#include "model/set/measured_twin.h"
#include "model/set/set_ratings.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

std::vector<TrainingSet> training_sets(const TrainingRequest& request) {
    std::vector<TrainingSet> sets;
    for (const SetToFit& rated : request.sets) {
        sets.push_back({rated.name, model_waveforms(*rated.set), *rated.study});
    }
    return sets;
}

std::optional<FoundTraining> find_parameters(const TrainingRequest& request, std::stop_token stop,
                                             std::atomic<float>& progress) {
    TrainingParams params;
    params.model = request.model;
    params.units = request.units;
    params.objective = request.objective;
    params.leave_out_participants = request.leave_out_participants;
    params.stop = stop;
    params.progress = [&progress](double share) { progress = static_cast<float>(share); };
    const std::vector<TrainingSet> sets = training_sets(request);
    FoundTraining found{request, {}, {}, {}};
    if (const auto fits = can_train(sets, params); !fits) {
        found.fault = fits.error().message;
        return found;
    }
    std::optional<Training> training = train(sets, params);
    if (!training) return std::nullopt;
    found.training = *std::move(training);
    found.record = record_of(found.training, sets, kProgramVersion);
    return found;
}

// People rate intended patterns: what measures them is left aside where it has no ratings.
Expected<SetToFit> rated_set(const PatternSet& set, const std::string& name) {
    SetToFit rated{name, std::make_shared<const PatternSet>(set), {}, 0, {}};
    Expected<RatingStudy> study = study_of(set);
    if (!study) {
        PatternSet intended = one_side(set, Side::intended);
        if (auto of_intended = study_of(intended)) {
            study = std::move(of_intended);
            rated.set = std::make_shared<const PatternSet>(std::move(intended));
        }
    }
    if (!study) return study.error();
    rated.people = participant_means(*study).size();
    rated.study = std::make_shared<const RatingStudy>(*std::move(study));
    if (std::ranges::any_of(set.ratings, is_synthetic)) rated.name += ", synthetic ratings";
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

bool differ(const TrainingRequest& asked, const TrainingRequest& now) {
    if (!same_choices(asked.model, now.model)) return true;
    return !std::ranges::equal(asked.sets, now.sets, [](const SetToFit& a, const SetToFit& b) {
        return a.file == b.file && (a.set == b.set || (a.set->vibrations == b.set->vibrations &&
                                                       a.set->ratings == b.set->ratings));
    });
}

std::string proposed_name(const FoundTraining& found) {
    return file_stem_of(found.request.sets.front().name + " " + found.record.date.substr(0, 10));
}

}  // namespace

void make_training_job(App& app) {
    app.training->job = std::make_unique<LatestJob<TrainingRequest, FoundTraining>>(
        JobPolicy::supersede, find_parameters, app.wake);
}

void stop_training(App& app) { app.training->job.reset(); }

std::shared_ptr<TrainingState> still_training(const TrainingState& state) {
    auto still = std::make_shared<TrainingState>();
    still->units = state.units;
    still->objective = state.objective;
    still->leave_out_participants = state.leave_out_participants;
    still->own_takes_part = state.own_takes_part;
    still->others = state.others;
    still->shows_ties = state.shows_ties;
    still->kept = state.kept;
    still->kept_were_read = true;
    still->found = state.found;
    return still;
}

void follow_training(App& app) {
    TrainingState& state = *app.training;
    if (!state.job) return;
    const auto latest = state.job->latest();
    if (!latest || latest == state.found) return;
    state.found = latest;
    state.scroll_to_result = latest->fault.empty();
    if (!latest->fault.empty()) complain(app, "Nothing to fit to: " + latest->fault);
}

bool is_training(const App& app) { return app.training->job && app.training->job->busy(); }

const OwnRatings& own_ratings(App& app) {
    OwnRatings& own = app.training->own;
    if (own.revision == app.revision) return own;
    const PatternSet& set = app.document.set;
    const bool same = own.set && own.set->set->vibrations == set.vibrations &&
                      own.set->set->ratings == set.ratings && own.set->set->name == set.name;
    own.revision = app.revision;
    if (same) return own;
    own.set.reset();
    own.fault.clear();
    if (set.ratings.empty()) return own;
    auto rated = rated_set(set, set.name.empty() ? "the open set" : set.name);
    if (rated) {
        own.set = *std::move(rated);
    } else {
        own.fault = rated.error().message;
    }
    return own;
}

TrainingRequest training_request(App& app) {
    const TrainingState& state = *app.training;
    TrainingRequest request{
        {}, app.document.set.model, state.units, state.objective, state.leave_out_participants};
    const OwnRatings& own = own_ratings(app);
    if (own.set && state.own_takes_part) request.sets.push_back(*own.set);
    std::ranges::copy_if(state.others, std::back_inserter(request.sets), &SetToFit::takes_part);
    return request;
}

void begin_training(App& app) {
    TrainingRequest request = training_request(app);
    if (request.sets.empty() || !app.training->job) return;
    app.training->since_s = app.time_s;
    app.training->job->submit(std::move(request));
}

void cancel_training(App& app) {
    if (app.training->job) app.training->job->cancel();
}

bool is_training_stale(App& app) {
    TrainingFreshness& fresh = app.training->freshness;
    const auto& found = app.training->found;
    if (!found) return false;
    const TrainingRequest now = training_request(app);
    std::vector<std::shared_ptr<const PatternSet>> sets;
    for (const SetToFit& rated : now.sets) sets.push_back(rated.set);
    const bool is_known = fresh.of == found && fresh.revision == app.revision && fresh.sets == sets;
    if (!is_known) fresh = {found, app.revision, sets, differ(found->request, now)};
    return fresh.is_stale;
}

void add_training_set_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::add_training_set,
                  .use = ChooserUse::open,
                  .title = "Add a set that has ratings",
                  .extensions = {".json"}},
                 app.document.path.parent_path());
}

void add_training_set(App& app, const fs::path& path) {
    const std::string file = path.filename().string();
    const auto taken = [&](const SetToFit& one) { return one.file == path; };
    if (path == app.document.path || std::ranges::any_of(app.training->others, taken)) {
        return complain(app, file + " takes part already.");
    }
    const auto loaded = load_set(path);
    if (!loaded) return complain(app, loaded.error().message);
    auto rated = rated_set(loaded->set, loaded->set.name.empty() ? file : loaded->set.name);
    if (!rated) {
        return complain(app, file + ": " + rated.error().message +
                                 "; open it and load its ratings, then save it");
    }
    rated->file = path;
    app.training->others.push_back(*std::move(rated));
    say(app, file + " takes part in training.");
}

void use_trained(App& app) {
    const auto found = app.training->found;  // kept while its list is read anew
    if (!found || !found->fault.empty()) return;
    const ModelFile content{found->training.model, found->record};
    const auto kept = keep_model(app, proposed_name(*found), content);
    use_model(app, content.model, "the trained parameters");
    if (!kept) complain(app, "In use, but not kept for other sets: " + kept.error().message);
}

void save_trained_dialog(App& app) {
    if (!app.training->found) return;
    ask_for_file(app,
                 {.purpose = ChooserPurpose::save_model,
                  .use = ChooserUse::save,
                  .title = "Save the trained parameters",
                  .extensions = {".json"}},
                 app.document.path.parent_path(),
                 proposed_name(*app.training->found) + kModelEnding);
}

void save_trained(App& app, const fs::path& path) {
    const auto& found = app.training->found;
    if (!found) return;
    const auto written = write_model_file(path, {found->training.model, found->record});
    if (!written) return complain(app, written.error().message);
    say(app, "Parameters saved to " + path.string() + ", for --model on the command line too.");
}

}  // namespace tact
