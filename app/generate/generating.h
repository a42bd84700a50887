// Candidates from the document's design space: what a draft would make, and making it.
#pragma once

#include "app/window/app.h"
#include "model/set/set_candidates.h"

namespace tact {

// Opens the dialog on the document's generator, or on the draft that was left; the first time on
// the current pattern with some of its parameters varied.
void open_generate(App& app);

// The pattern's own values, all fixed.
DesignSpace space_around(const Pattern& pattern);

// The work of the dialog's job.
std::optional<GeneratePlan> plan_of(const GenerateRequest& request, std::stop_token stop);

// Asks for the plan of the draft where it is not what was asked for last.
void follow_generate(App& app);

// The plan of the draft and the document as they are; null while it is being made.
std::shared_ptr<const GeneratePlan> current_plan(const App& app);

// Puts the candidates of a plan into the document, with its generator: one step of undo. The first
// of them is selected.
void add_candidates(App& app, const GeneratePlan& plan, Before before);

}  // namespace tact
