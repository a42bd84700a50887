#include "model/tasks/set_training.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "model/text/numbers.h"

namespace tact {

namespace {

using Json = nlohmann::json;

TrainingParams params_of(const TrainRequest& request) {
    TrainingParams params;
    params.model = request.model;
    params.units = request.units;
    params.objective = request.objective;
    params.leave_out_participants = request.leave_out == LeaveOut::participants;
    params.leave_out_patterns = request.leave_out == LeaveOut::patterns;
    params.threads = request.threads;
    params.stop = request.stop;
    params.progress = request.progress;
    return params;
}

Json json_of(const PerceptualModelParams& model) {
    Json json = Json::object();
    const auto values = trained_values(model);
    for (std::size_t p = 0; p < values.size(); ++p) json[kTrainedNames[p]] = values[p];
    return json;
}

Json json_of(const std::vector<LeftOut>& left_out) {
    Json all = Json::array();
    for (const LeftOut& one : left_out) {
        all.push_back({{"name", one.name},
                       {"parameters", json_of(one.model)},
                       {"value", one.value},
                       {"combinations", one.combinations},
                       {"rho_before", one.rho_before},
                       {"rho_after", one.rho_after}});
    }
    return all;
}

// The parameters of a class: the smallest of its proportion.
Json json_of(const Training& training, const GridPoint& point) {
    PerceptualModelParams none;
    none.channel_weight = {};
    none.nc_weight = none.oc_weight = 0.0;
    Json json = json_of(nearest_model(training.grid, point, none));
    for (std::size_t p = 0; point.channel == kAny && p < 6; ++p) json[kTrainedNames[p]] = nullptr;
    return {{"parameters", json}, {"combinations", combinations_of(training.grid, point)}};
}

Json json_of(const TrainedSet& set, const RatingStudy& study) {
    return {{"name", set.name},
            {"patterns", set.patterns},
            {"rated_pairs", set.rated_pairs},
            {"participants", participant_means(study).size()},
            {"synthetic", is_partly_synthetic(study)},
            {"unrated_patterns", unrated_patterns(study)},
            {"rho_before", set.rho_before},
            {"rho_after", set.rho_after}};
}

}  // namespace

TrainingSet training_set(std::string name, const PatternSet& felt, RatingStudy study, int threads) {
    return {std::move(name), own_waveforms(felt, threads), std::move(study)};
}

Expected<int> units_of_step(double step) {
    for (int units = 1; units <= kMostTrainingUnits; ++units) {
        if (std::abs(step * units - 1.0) < 1e-9) return units;
    }
    return Error{"expected 1 divided by a whole number up to " +
                 std::to_string(kMostTrainingUnits) + ", such as 0.1, got " +
                 shortest_digits(step)};
}

Expected<Done> can_train(const TrainRequest& request) {
    if (request.leave_out == LeaveOut::sets && request.sets.size() == 1) {
        return Error{"expected several sets with ratings to leave one out, got one"};
    }
    return can_train(request.sets, params_of(request));
}

std::optional<Trained> train(const TrainRequest& request) {
    std::optional<Training> training = train(request.sets, params_of(request));
    if (!training) return std::nullopt;
    TrainingRecord record = record_of(*training, request.sets, request.program);
    return Trained{*std::move(training), std::move(record)};
}

Json json_of(const Trained& trained, const TrainRequest& request) {
    const Training& training = trained.training;
    Json best_of = Json::object();
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        best_of[kTrainedNames[p]] = training.best_of[p];
    }
    Json sets = Json::array();
    for (std::size_t s = 0; s < training.sets.size(); ++s) {
        sets.push_back(json_of(training.sets[s], request.sets[s].study));
    }
    Json ties = Json::array();
    for (const GridPoint& point : training.best.points) ties.push_back(json_of(training, point));
    Json all = {{"objective", kObjectiveNames[static_cast<std::size_t>(training.objective)]},
                {"step", 1.0 / training.grid.units},
                {"value", training.best.value},
                {"value_before", training.value_before},
                {"parameters", json_of(training.model)},
                {"parameters_before", json_of(training.before)},
                {"combinations", combination_count(training.grid.units)},
                {"equally_good", training.best.combinations},
                {"equally_good_classes", training.best.classes},
                {"ties", ties},
                {"share_near_best", training.share_near_best},
                {"near_best", kNearBest},
                {"best_of", best_of},
                {"synthetic", is_partly_synthetic(trained.record)},
                {"sets", sets}};
    if (training.sets.size() > 1) all["without_set"] = json_of(training.without_set);
    if (request.leave_out == LeaveOut::participants) {
        all["without_participant"] = json_of(training.without_participant);
    }
    if (request.leave_out == LeaveOut::patterns) {
        all["without_pattern"] = json_of(training.without_pattern);
    }
    return all;
}

}  // namespace tact
