// Candidates from the document's design space: what a draft would make, and making it.
#pragma once

#include "app/document/workspace.h"
#include "app/generate/generate_state.h"
#include "app/ui/ui.h"
#include "model/set/set_candidates.h"

namespace tact {

// Opens the dialog on the document's generator, or on the draft that was left; the first time on
// the current pattern with some of its parameters varied.
void open_generate(Ui& ui, const Workspace& work, GenerateState& generating);

// The pattern's own values, all fixed.
DesignSpace space_around(const Pattern& pattern);

// The work of the dialog's job.
std::optional<GeneratePlan> plan_of(const GenerateRequest& request, std::stop_token stop);

// Asks for the plan of the draft where it is not what was asked for last.
void follow_generate(const Ui& ui, const Workspace& work, GenerateState& generating);

// The plan of the present draft and document; null while it is being made.
std::shared_ptr<const GeneratePlan> current_plan(const Workspace& work,
                                                 const GenerateState& generating);

// Puts the candidates of a plan into the document, with its generator: one step of undo. The first
// of them is selected.
void add_candidates(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan& plan,
                    Before before);

}  // namespace tact
