// What the dialog on a study's plan was left at, and what was simulated.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/jobs/query.h"
#include "model/planning/set_plan.h"
#include "model/set/pattern_set.h"

namespace tact {

struct PlanChoice {
    Metric rival = Metric::msm;
    int first = 5;  // numbers of people
    int last = 40;
    bool all_pairs = true;  // each person rates every pair, else `pairs` of them
    int pairs = 20;
    bool all_patterns = true;  // of the study, else the `decide` on which the two disagree most
    int decide = 8;
    bool by_ratings = false;  // people are assumed to be as those of the set's ratings
    double rho = guessed_assumptions().rho;
    double reliability = guessed_assumptions().reliability;

    bool operator==(const PlanChoice&) const = default;
};

struct PlanRequest {
    std::uint64_t document = 0;
    std::uint64_t revision = 0;
    PlanChoice choice;
    std::shared_ptr<const PatternSet> set;  // with the patterns of its study alone

    bool operator==(const PlanRequest& other) const {
        return document == other.document && revision == other.revision && choice == other.choice;
    }
};

struct LivePlan {
    PlanRequest request;
    Expected<SetPlan> plan;
};

struct PlanState {
    PlanChoice choice;
    Query<PlanRequest, LivePlan> job;
    std::optional<std::size_t> chosen{};  // a row: the number of people to preregister
};

}  // namespace tact
