#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/python/parts.h"
#include "model/io/set/model_file.h"
#include "model/planning/study_plan.h"
#include "model/training/training.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;

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

py::dict trained_dict(const PerceptualModelParams& model) {
    py::dict result;
    const auto values = trained_values(model);
    for (std::size_t p = 0; p < values.size(); ++p) result[kTrainedNames[p]] = values[p];
    return result;
}

py::list list_of(const std::vector<LeftOut>& left_out) {
    py::list all;
    for (const LeftOut& one : left_out) {
        all.append(py::dict("name"_a = one.name, "parameters"_a = trained_dict(one.model),
                            "value"_a = one.value, "combinations"_a = one.combinations,
                            "rho_before"_a = one.rho_before, "rho_after"_a = one.rho_after));
    }
    return all;
}

py::dict dict_of(const Training& training, std::span<const TrainingSet> given) {
    py::dict best_of;
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        best_of[kTrainedNames[p]] = array_of(training.best_of[p]);
    }
    py::list sets;
    bool synthetic = false;
    for (std::size_t k = 0; k < given.size(); ++k) {
        const TrainedSet& set = training.sets[k];
        const bool is_synthetic = is_partly_synthetic(given[k].study);
        synthetic = synthetic || is_synthetic;
        sets.append(py::dict("name"_a = set.name, "patterns"_a = set.patterns,
                             "rated_pairs"_a = set.rated_pairs, "synthetic"_a = is_synthetic,
                             "participants_left_out"_a = given[k].study.left_out,
                             "rehearsals_left_out"_a = given[k].study.rehearsals,
                             "rho_before"_a = set.rho_before, "rho_after"_a = set.rho_after));
    }
    const ModelFile file{training.model, record_of(training, given, "tactspace " TACT_VERSION)};
    return py::dict("model"_a = python_of(training.model, origin_of(file)),
                    "parameters"_a = trained_dict(training.model),
                    "parameters_before"_a = trained_dict(training.before),
                    "value"_a = training.best.value, "value_before"_a = training.value_before,
                    "combinations"_a = combination_count(training.grid.units),
                    "equally_good"_a = training.best.combinations,
                    "share_near_best"_a = training.share_near_best, "near_best"_a = kNearBest,
                    "best_of"_a = best_of, "synthetic"_a = synthetic, "sets"_a = sets,
                    "without_set"_a = list_of(training.without_set),
                    "without_participant"_a = list_of(training.without_participant),
                    "without_pattern"_a = list_of(training.without_pattern));
}

// A weight in steps of this.
int units_of(double step) {
    for (int units = 1; units <= kMostTrainingUnits; ++units) {
        if (std::abs(step * units - 1.0) < 1e-9) return units;
    }
    throw py::value_error("step: expected 1 divided by a whole number up to " +
                          std::to_string(kMostTrainingUnits) + ", such as 0.1");
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

// Pads waveforms to one length, as those of a set are.
std::vector<Waveform> padded_to_longest(std::vector<Waveform> waves) {
    std::size_t longest = 0;
    for (const Waveform& wave : waves) longest = std::max(longest, wave.samples_g.size());
    for (Waveform& wave : waves) wave = padded(std::move(wave), longest);
    return waves;
}

}  // namespace

py::dict train_sets(const py::object& given, const py::object& objective, const py::object& step,
                    const py::object& leave_out, const py::object& rate_hz,
                    const py::object& threads, py::object model, const py::object& progress) {
    Progress told(progress);
    const double rate = rate_of(rate_hz);
    const std::vector<py::dict> dicts = dicts_in(given, "sets");
    if (dicts.empty()) throw py::value_error("sets: expected at least one");
    if (model.is_none() && dicts.front().contains("model")) model = dicts.front()["model"];
    std::vector<TrainingSet> sets;
    for (const py::dict& set : dicts) sets.push_back(training_set_of(set, sets.size(), rate));
    constexpr const char* kLeftOut[] = {"", "sets", "participants", "patterns"};
    const std::size_t left_out = choice_of(leave_out, "leave_out", kLeftOut);
    if (left_out == 1 && sets.size() < 2) {
        throw py::value_error("leave_out: expected several sets to leave one out, got one");
    }
    TrainingParams params;
    params.model = model_of(model);
    params.units = units_of(within(step, "step", {0.0, 1.0}));
    params.objective =
        static_cast<TrainingObjective>(choice_of(objective, "objective", kObjectiveNames));
    params.leave_out_participants = left_out == 2;
    params.leave_out_patterns = left_out == 3;
    params.threads = threads_of(threads);
    value_of(can_train(sets, params));
    params.progress = told.for_work("training");
    const auto training = beside_python(
        [&](std::stop_token stop) {
            for (TrainingSet& set : sets) {
                set.waveforms = padded_to_longest(at_model_rate(std::move(set.waveforms), stop));
            }
            params.stop = stop;
            return train(sets, params);
        },
        &told);
    return dict_of(*training, sets);
}

}  // namespace tact
