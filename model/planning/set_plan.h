// The plan of a study of a set: what is assumed of people, its patterns, and the simulated studies.
//
// Input     a set, the rival that PM is to be told from, numbers of people; a pilot or what is
//           stated of people, else a guess
// Output    the patterns that are planned with, both matrices of them, a PlannedStudy for each
//           number of people
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/evaluation/metric.h"
#include "model/planning/deciding.h"
#include "model/planning/preregistration.h"
#include "model/planning/study_plan.h"
#include "model/set/pattern_set.h"

namespace tact {

inline constexpr std::size_t kMostPlannedPeople = 1000;

// Eight numbers of people, evenly spaced, or all from the first to the last if there are fewer.
std::vector<std::size_t> people_between(std::size_t first, std::size_t last);

struct PlanQuestion {
    PatternSet set;
    Metric rival = Metric::msm;
    std::vector<std::size_t> people;
    std::size_t pairs = 0;               // that each rates; 0: every pair
    std::size_t decide = 0;              // patterns on which the two disagree most; 0: all
    std::optional<RatingStudy> pilot{};  // of the set's patterns
    std::string of_pilot{};              // what has to be said of it; empty: nothing
    std::optional<double> rho{};         // stated, in place of the pilot's or the guess
    std::optional<double> reliability{};
    std::size_t studies = 200;  // simulated, of each number of people
    std::uint64_t seed = 12;
    int threads = 0;  // 0: all cores
};

struct SetPlan {
    PatternSet set;  // those that are planned with
    Metric rival = Metric::msm;
    StudyPlan plan;
    std::optional<DecidingPatterns> decided;
    std::vector<PlannedStudy> studies;
};

struct PlanWatch {
    std::stop_token stop{};
    // What is done, and its share, 0..1.
    std::function<void(const char*, double)> progress{};
};

// Errors: fewer patterns than can be rated, the rival is PM itself, more pairs or patterns than
// there are, a pilot that says nothing, or stopped.
Expected<SetPlan> set_plan(const PlanQuestion& question, const PlanWatch& watch = {});

// Minutes a person takes, by the design of the set.
double minutes_of(const SetPlan& plan);

// The plan frozen, of the only number of people that it has. `program` with its version; `date`
// UTC.
Preregistration preregistration_of(const SetPlan& plan, const std::string& name,
                                   const std::string& program, const std::string& date);

}  // namespace tact
