#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/python/parts.h"
#include "model/planning/study_plan.h"
#include "model/tasks/set_training.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;  // NOLINT(google-build-using-namespace): of _a

namespace {

py::dict by_resample(const std::array<double, kResampledCount>& values) {
    py::dict dict;
    for (std::size_t r = 0; r < kResampledCount; ++r) dict[kResampledNames[r]] = values[r];
    return dict;
}

PlanAssumptions assumed_of(const py::object& pilot, const Dissimilarity& metric,
                           const std::optional<double>& rho,
                           const std::optional<double>& reliability) {
    PlanAssumptions assumed = guessed_assumptions();
    if (!pilot.is_none()) {
        const RatingStudy study = study_of(pilot);
        if (study.labels.size() != metric.size) {
            throw py::value_error("pilot: expected ratings of the " + std::to_string(metric.size) +
                                  " patterns of D, got those of " +
                                  std::to_string(study.labels.size()));
        }
        assumed = value_of(assumptions_of(study, metric));
    }
    if (rho) assumed.rho = *rho;
    if (reliability) assumed.reliability = *reliability;
    if (rho || reliability) {
        const bool are_all = rho && (reliability || !pilot.is_none());
        assumed.source = pilot.is_none() ? (are_all ? "stated" : "stated, and the rest guessed")
                                         : "stated, and " + assumed.source;
    }
    return assumed;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): it has the arguments of Python's
py::dict plan_study(const py::object& matrix, const py::object& rival, const py::object& people,
                    const py::object& rho, const py::object& reliability, const py::object& pilot,
                    const py::object& pairs, const py::object& studies, const py::object& seed,
                    const py::object& threads, const py::object& progress) {
    constexpr double kMostPeople = 1000.0;
    Progress told(progress);
    StudyPlan plan;
    plan.metric = dissimilarities_of(matrix, "D");
    plan.rival = dissimilarities_of(rival, "rival");
    if (plan.rival.size != plan.metric.size || plan.metric.size < kLeastRated) {
        throw py::value_error("rival: expected the patterns of D, three at least, got " +
                              std::to_string(plan.rival.size) + " for " +
                              std::to_string(plan.metric.size));
    }
    std::vector<std::size_t> counts;
    for (const int one : wholes_within(people, "people", {1.0, kMostPeople})) {
        counts.push_back(static_cast<std::size_t>(one));
    }
    if (counts.empty()) throw py::value_error("people: expected at least one number");
    const auto all = static_cast<double>(pair_count(plan.metric.size));
    plan.pairs = static_cast<std::size_t>(whole_within(pairs, "pairs", {0.0, all}));
    plan.assumed = assumed_of(pilot, plan.metric, optional_within(rho, "rho", {0.0, 1.0}),
                              optional_within(reliability, "reliability", {0.01, 1.0}));
    PlanParams params;
    params.studies = static_cast<std::size_t>(whole_within(studies, "studies", {20.0, 1e4}));
    params.seed = static_cast<std::uint64_t>(whole_within(seed, "seed", {0.0, 1e9}));
    params.threads = threads_of(threads);
    params.progress = told.for_work("simulating studies");
    const auto planned = beside_python(
        [&](std::stop_token stop) {
            params.stop = stop;
            return planned_studies(plan, counts, params);
        },
        &told);
    py::list rows;
    for (const PlannedStudy& one : *planned) {
        rows.append(py::dict("people"_a = one.people, "rho"_a = one.rho, "rho_sd"_a = one.rho_sd,
                             "rho_rival"_a = one.rho_rival, "reliability"_a = one.reliability,
                             "half_width"_a = by_resample(one.half_width),
                             "power"_a = by_resample(one.power)));
    }
    return py::dict("simulated"_a = true,
                    "assumed"_a = py::dict("rho"_a = plan.assumed.rho,
                                           "reliability"_a = plan.assumed.reliability,
                                           "source"_a = plan.assumed.source),
                    "studies"_a = rows);
}

namespace {

// With the model to predict with, and arrays in place of lists.
py::dict dict_of(const Trained& trained, const TrainRequest& request) {
    py::dict dict = python_of(json_of(trained, request));
    const Training& training = trained.training;
    dict["model"] = python_of(training.model, origin_of({training.model, trained.record}));
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        dict["best_of"][kTrainedNames[p]] = array_of(training.best_of[p]);
    }
    for (std::size_t k = 0; k < request.sets.size(); ++k) {
        const RatingStudy& study = request.sets[k].study;
        dict["sets"][py::int_(k)]["participants_left_out"] = study.left_out;
        dict["sets"][py::int_(k)]["rehearsals_left_out"] = study.rehearsals;
    }
    for (const char* key : {"without_set", "without_participant", "without_pattern"}) {
        if (!dict.contains(key)) dict[key] = py::list();
    }
    return dict;
}

TrainingSet training_set_of(const py::dict& set, std::size_t number, double rate_hz) {
    const std::string name = set.contains("name") ? text_in(set["name"], "name") : std::string();
    if (!set.contains("waves") || !set.contains("ratings") || set["ratings"].is_none()) {
        throw py::value_error("sets[" + std::to_string(number) +
                              "]: expected a dict with \"waves\" and \"ratings\"");
    }
    TrainingSet result{name.empty() ? "set " + std::to_string(number + 1) : name,
                       waves_of(set["waves"], rate_hz), study_of(py::object(set["ratings"]))};
    if (result.study.labels.size() == result.waveforms.size()) return result;
    throw py::value_error("sets[" + std::to_string(number) + "]: expected ratings of its " +
                          std::to_string(result.waveforms.size()) + " waves, got those of " +
                          std::to_string(result.study.labels.size()) + " patterns");
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): it has the arguments of Python's
py::dict train_sets(const py::object& given, const py::object& objective, const py::object& step,
                    const py::object& leave_out, const py::object& rate_hz,
                    const py::object& threads, py::object model, const py::object& progress) {
    Progress told(progress);
    const double rate = rate_of(rate_hz);
    const std::vector<py::dict> dicts = dicts_in(given, "sets");
    if (dicts.empty()) throw py::value_error("sets: expected at least one");
    if (model.is_none() && dicts.front().contains("model")) model = dicts.front()["model"];
    TrainRequest request;
    for (const py::dict& set : dicts) {
        request.sets.push_back(training_set_of(set, request.sets.size(), rate));
    }
    request.model = model_of(model);
    const auto units = units_of_step(within(step, "step", {0.0, 1.0}));
    if (!units) throw py::value_error("step: " + units.error().message);
    request.units = *units;
    request.objective =
        static_cast<TrainingObjective>(choice_of(objective, "objective", kObjectiveNames));
    request.leave_out = static_cast<LeaveOut>(choice_of(leave_out, "leave_out", kLeaveOutNames));
    request.program = "tactspace " TACT_VERSION;
    request.threads = threads_of(threads);
    value_of(can_train(request));
    request.progress = told.for_work("training");
    const auto trained = beside_python(
        [&](std::stop_token stop) {
            for (TrainingSet& set : request.sets) {
                set.waveforms = at_model_rate(std::move(set.waveforms), stop);
            }
            request.stop = stop;
            return train(request);
        },
        &told);
    return dict_of(*trained, request);
}

}  // namespace tact
