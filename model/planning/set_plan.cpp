#include "model/planning/set_plan.h"

#include <algorithm>
#include <utility>

#include "model/common/fingerprint.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/set/set_ratings.h"

namespace tact {

namespace {

Error stopped_planning() { return Error{"stopped before the study was planned"}; }

std::function<void(double)> phase(const PlanWatch& watch, const char* what) {
    if (!watch.progress) return {};
    return [&watch, what](double share) { watch.progress(what, share); };
}

PatternSet only(const PatternSet& set, const std::vector<std::size_t>& places) {
    PatternSet some = set;
    some.vibrations.clear();
    for (const std::size_t place : places) some.vibrations.push_back(set.vibrations[place]);
    some.study.patterns.clear();
    some.ratings.clear();
    return some;
}

std::optional<std::vector<Dissimilarity>> both_matrices(const PatternSet& set,
                                                        const PlanQuestion& question,
                                                        const PlanWatch& watch) {
    MetricOptions options;
    options.threads = question.threads;
    options.stop = watch.stop;
    options.progress = phase(watch, "comparing patterns");
    return compared_matrices(set, std::vector{Metric::pm, question.rival}, nullptr, options);
}

// The deciding patterns in the place of all, with matrices of their own: PM ranks the pairs of the
// set that it is given.
Expected<Done> decide(const PlanQuestion& question, const PlanWatch& watch, SetPlan& answer) {
    DecidingParams how;
    how.threads = question.threads;
    how.stop = watch.stop;
    how.progress = phase(watch, "choosing patterns");
    answer.decided = deciding_patterns(answer.plan.metric, answer.plan.rival, question.decide, how);
    if (!answer.decided) return stopped_planning();
    answer.set = only(answer.set, answer.decided->patterns);
    const auto matrices = both_matrices(answer.set, question, watch);
    if (!matrices) return stopped_planning();
    answer.plan.metric = (*matrices)[0];
    answer.plan.rival = (*matrices)[1];
    return Done{};
}

// `pm`: of all patterns, which the pilot rated, whichever of them are planned with.
Expected<PlanAssumptions> assumed(const PlanQuestion& question, const Dissimilarity& pm) {
    PlanAssumptions all = guessed_assumptions();
    if (question.pilot) {
        Expected<PlanAssumptions> found = assumptions_of(*question.pilot, pm);
        if (!found) return found;
        all = *std::move(found);
        if (!question.of_pilot.empty()) all.source += "; " + question.of_pilot;
    }
    if (!question.rho && !question.reliability) return all;
    if (question.rho) all.rho = *question.rho;
    if (question.reliability) all.reliability = *question.reliability;
    const bool are_all_stated = question.rho && question.reliability;
    all.source = are_all_stated   ? "stated"
                 : question.pilot ? "stated, and " + all.source
                                  : "stated, and the rest guessed";
    return all;
}

Expected<Done> check(const PlanQuestion& question) {
    const std::size_t patterns = question.set.vibrations.size();
    if (patterns < kLeastRated) {
        return Error{"expected at least " + std::to_string(kLeastRated) + " patterns, got " +
                     std::to_string(patterns)};
    }
    if (question.rival == Metric::pm) return Error{"--rival: expected another metric than pm"};
    if (question.decide > patterns) {
        return Error{"--decide: expected at most the " + std::to_string(patterns) +
                     " patterns of the set, got " + std::to_string(question.decide)};
    }
    const std::size_t pairs = pair_count(question.decide == 0 ? patterns : question.decide);
    if (question.pairs > pairs) {
        return Error{"--pairs: expected all, or a number from 1 to the " + std::to_string(pairs) +
                     " pairs of these patterns, got " + std::to_string(question.pairs)};
    }
    return Done{};
}

}  // namespace

std::vector<std::size_t> people_between(std::size_t first, std::size_t last) {
    constexpr std::size_t kMost = 8;
    const std::size_t steps = std::min(kMost - 1, last - first);
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k <= steps; ++k) {
        all.push_back(first + (steps == 0 ? 0 : (k * (last - first) + steps / 2) / steps));
    }
    return all;
}

Expected<SetPlan> set_plan(const PlanQuestion& question, const PlanWatch& watch) {
    if (const auto checked = check(question); !checked) return checked.error();
    SetPlan answer;
    answer.set = question.set;
    answer.rival = question.rival;
    auto matrices = both_matrices(answer.set, question, watch);
    if (!matrices) return stopped_planning();
    Expected<PlanAssumptions> people = assumed(question, (*matrices)[0]);
    if (!people) return people.error();
    answer.plan.assumed = *std::move(people);
    answer.plan.metric = std::move((*matrices)[0]);
    answer.plan.rival = std::move((*matrices)[1]);
    if (question.decide != 0) {
        if (const auto decided = decide(question, watch, answer); !decided) return decided.error();
    }
    if (question.pairs != pair_count(answer.set.vibrations.size())) {
        answer.plan.pairs = question.pairs;
    }
    PlanParams how;
    how.studies = question.studies;
    how.seed = question.seed;
    how.threads = question.threads;
    how.stop = watch.stop;
    how.progress = phase(watch, "simulating studies");
    auto studies = planned_studies(answer.plan, question.people, how);
    if (!studies) return stopped_planning();
    answer.studies = *std::move(studies);
    return answer;
}

double minutes_of(const SetPlan& plan) {
    double longest_s = 0.0;
    for (const Vibration& one : plan.set.vibrations) {
        longest_s = std::max(longest_s, own_duration_s(one));
    }
    const std::size_t patterns = plan.set.vibrations.size();
    const double minutes = predicted_minutes(plan.set.study, patterns, longest_s);
    if (plan.plan.pairs == 0) return minutes;
    return minutes * static_cast<double>(plan.plan.pairs) /
           static_cast<double>(pair_count(patterns));
}

Preregistration preregistration_of(const SetPlan& plan, const std::string& name,
                                   const std::string& program, const std::string& date) {
    Preregistration frozen;
    frozen.date = date;
    frozen.program = program;
    frozen.set_name = name;
    frozen.patterns = names_of(plan.set);
    frozen.set_fingerprint = study_fingerprint(plan.set, frozen.patterns);
    frozen.model_fingerprint = fingerprint_text(model_fingerprint(plan.set));
    frozen.people = plan.studies.front().people;
    frozen.pairs = plan.plan.pairs;
    frozen.repetitions = plan.set.study.repetitions;
    frozen.attention_pairs = plan.set.study.attention_pairs;
    frozen.attention = plan.set.study.attention;
    frozen.order = plan.set.study.order;
    frozen.rival = traits(plan.rival).key;
    frozen.assumed = plan.plan.assumed;
    frozen.expected = plan.studies.front();
    return frozen;
}

}  // namespace tact
