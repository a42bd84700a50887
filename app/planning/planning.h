// A study before it is run: people, patterns, preregistration.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/planning/set_plan.h"
#include "model/set/pattern_set.h"

namespace tact {

// What the dialog on a study's plan was left at, and what was simulated.

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

// The dialog on a study's plan.

inline constexpr Dialog kPlanDialog{.title = "Plan the study", .is_of_document = true};
void draw_plan_dialog(Ui& ui, Workspace& work, PlanState& planning);

// A study before it is run: how many people, which patterns, and the plan frozen in a folder.
//
// Input     the patterns of the document's study, when that is asked for
// Output    an answer that goes stale with the document or the choice; whole files
// Exact     the numbers of "tactspace plan".

// Why nothing can be planned, a sentence; empty: it can.
std::string plan_obstacle(const Workspace& work);

void simulate_plan(Ui& ui, const Workspace& work, PlanState& planning);
bool is_planning(const PlanState& planning);

// The answer is of the document and the choice as they are.
bool is_plan_current(const Workspace& work, const PlanState& planning);

// The patterns that were planned with become those of the study: one step.
void use_planned_patterns(Ui& ui, Workspace& work, const SetPlan& plan);

// Where to, and then the files. A folder that has a preregistration keeps it.
void choose_preregistration_folder(Ui& ui, const Workspace& work, const PlanState& planning);
void preregister(Ui& ui, const Workspace& work, const PlanState& planning,
                 const std::filesystem::path& folder);

}  // namespace tact
