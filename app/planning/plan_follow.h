// A study before it is run: how many people, which patterns, and the plan frozen in a folder.
//
// Input     the patterns of the document's study, when that is asked for
// Output    an answer that goes stale with the document or the choice; whole files
// Exact     the numbers of "tactspace plan".
#pragma once

#include <filesystem>

#include "app/document/workspace.h"
#include "app/planning/plan_state.h"
#include "app/ui/ui.h"

namespace tact {

// Why nothing can be planned, a sentence; empty: it can.
std::string plan_obstacle(const Workspace& work);

void simulate_plan(Ui& ui, const Workspace& work, PlanState& planning);
bool is_planning(const PlanState& planning);

// The answer is of the document and the choice as they are.
bool is_plan_current(const Workspace& work, const PlanState& planning);

// The patterns that were planned with become those of the study: one step.
void use_planned_patterns(Ui& ui, Workspace& work, const SetPlan& plan);

// Where to, and then the files. A folder that has a preregistration keeps it.
void choose_preregistration_folder(Ui& ui, const Workspace& work);
void preregister(Ui& ui, const Workspace& work, const PlanState& planning,
                 const std::filesystem::path& folder);

}  // namespace tact
