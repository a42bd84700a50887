#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/python/beside_python.h"
#include "app/python/functions.h"
#include "app/python/values.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/model_file.h"
#include "model/io/set/model_json.h"
#include "model/planning/study_plan.h"
#include "model/training/training.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;

namespace {

py::dict dict_of(const Evaluation& e, const RatedPeople& people) {
    const Reliability& reliability = people.reliability;
    return py::dict(
        "rho"_a = e.rho, "rho_low"_a = e.rho_interval.low, "rho_high"_a = e.rho_interval.high,
        "p"_a = e.rho_p, "tau_b"_a = e.tau_b, "K"_a = e.k,
        "K_paper"_a = agreement_of(e, Bookkeeping::paper).k, "K_low"_a = e.k_spread.low,
        "K_high"_a = e.k_spread.high, "K_chance"_a = rated_part(people.rated).k_chance.mean,
        "K_p"_a = e.k_p, "K_corrected"_a = e.k_corrected, "K_procrustes"_a = e.k_procrustes,
        "protest_p"_a = e.protest_p, "stress1"_a = e.stress1,
        "reliability"_a = reliability.spearman_brown,
        "one_with_others"_a = reliability.one_with_others,
        "ceiling_of_mean"_a = reliability.ceiling_of_mean, "participants"_a = people.participants,
        "synthetic"_a = people.mark.synthetic, "participants_left_out"_a = people.mark.left_out,
        "rehearsals_left_out"_a = people.mark.rehearsals, "unrated_patterns"_a = people.unrated,
        "remarks"_a = e.remarks);
}

}  // namespace

py::dict compare(const py::object& matrix, const py::object& ratings, const std::string& metric,
                 int threads) {
    Dissimilarity dissimilarity = dissimilarities_of(matrix, "D");
    const RatingStudy study = study_of(ratings);
    if (study.labels.size() != dissimilarity.size) {
        throw py::value_error("ratings: expected those of the " +
                              std::to_string(dissimilarity.size) + " patterns of D, got " +
                              std::to_string(study.labels.size()));
    }
    if (!metric.empty()) {
        const Metric by = value_of(metric_named(metric));
        if (by == Metric::spqi) {
            dissimilarity.condensed = average_ranks(values_to_rank(by, dissimilarity));
        }
    }
    EvaluationParams params;
    params.threads = threads_of(threads);
    const RatedPeople people = value_of(
        beside_python([&](const std::stop_token&) { return rated_people(study, params); }));
    const Evaluation evaluation = beside_python(
        [&](const std::stop_token&) { return evaluate(dissimilarity, people.rated, params); });
    return dict_of(evaluation, people);
}

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
    if (rho) assumed.rho = within(*rho, "rho", {0.0, 1.0});
    if (reliability) assumed.reliability = within(*reliability, "reliability", {0.01, 1.0});
    if (rho || reliability) {
        const bool are_all = rho && (reliability || !pilot.is_none());
        assumed.source = pilot.is_none() ? (are_all ? "stated" : "stated, and the rest guessed")
                                         : "stated, and " + assumed.source;
    }
    return assumed;
}

}  // namespace

py::dict plan_study(const py::object& matrix, const py::object& rival,
                    const std::vector<int>& people, const std::optional<double>& rho,
                    const std::optional<double>& reliability, const py::object& pilot, int pairs,
                    int studies, int seed, int threads) {
    constexpr int kMostPeople = 1000;
    StudyPlan plan;
    plan.metric = dissimilarities_of(matrix, "D");
    plan.rival = dissimilarities_of(rival, "rival");
    if (plan.rival.size != plan.metric.size || plan.metric.size < kLeastRated) {
        throw py::value_error("rival: expected the patterns of D, three at least, got " +
                              std::to_string(plan.rival.size) + " for " +
                              std::to_string(plan.metric.size));
    }
    if (people.empty()) throw py::value_error("people: expected at least one number");
    std::vector<std::size_t> counts;
    for (const int one : people) {
        counts.push_back(static_cast<std::size_t>(whole_within(one, "people", {1.0, kMostPeople})));
    }
    const auto all = static_cast<double>(pair_count(plan.metric.size));
    plan.pairs = static_cast<std::size_t>(whole_within(pairs, "pairs", {0.0, all}));
    plan.assumed = assumed_of(pilot, plan.metric, rho, reliability);
    PlanParams params;
    params.studies = static_cast<std::size_t>(whole_within(studies, "studies", {20.0, 1e4}));
    params.seed = static_cast<std::uint64_t>(whole_within(seed, "seed", {0.0, 1e9}));
    params.threads = threads_of(threads);
    const auto planned = beside_python([&](std::stop_token stop) {
        params.stop = stop;
        return planned_studies(plan, counts, params);
    });
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
    return py::dict("model"_a = python_of(json_of(training.model)),
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
    const std::string name = set.contains("name") ? set["name"].cast<std::string>() : std::string();
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

py::dict train_sets(const std::vector<py::dict>& given, const std::string& objective, double step,
                    const std::string& leave_out, double rate_hz, int threads, py::object model) {
    if (given.empty()) throw py::value_error("sets: expected at least one");
    if (model.is_none() && given.front().contains("model")) model = given.front()["model"];
    std::vector<TrainingSet> sets;
    for (const py::dict& set : given) sets.push_back(training_set_of(set, sets.size(), rate_hz));
    constexpr const char* kLeftOut[] = {"", "sets", "participants", "patterns"};
    const std::size_t left_out = choice_of(leave_out, "leave_out", kLeftOut);
    if (left_out == 1 && sets.size() < 2) {
        throw py::value_error("leave_out: expected several sets to leave one out, got one");
    }
    TrainingParams params;
    params.model = model_of(model);
    params.units = units_of(step);
    params.objective =
        static_cast<TrainingObjective>(choice_of(objective, "objective", kObjectiveNames));
    params.leave_out_participants = left_out == 2;
    params.leave_out_patterns = left_out == 3;
    params.threads = threads_of(threads);
    value_of(can_train(sets, params));
    const auto training = beside_python([&](std::stop_token stop) {
        for (TrainingSet& set : sets) {
            set.waveforms = padded_to_longest(at_model_rate(std::move(set.waveforms)));
        }
        params.stop = stop;
        return train(sets, params);
    });
    return dict_of(*training, sets);
}

}  // namespace tact
