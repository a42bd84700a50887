// Even steps between two patterns of the set: asking for them, and taking them into the set.
#pragma once

#include <memory>
#include <string>

#include "app/ask/steps_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Opens the dialog on these two names; empty ones: the pattern in the editor and its partner, or
// the pattern after it.
void open_steps(Ui& ui, const Workspace& work, StepsState& state, const std::string& from,
                const std::string& to);

// Why there is no question, as a sentence; empty: there is one.
std::string steps_obstacle(const Workspace& work, const StepsState& state);
std::optional<StepsRequest> steps_request(const Workspace& work, const StepsState& state);

// Asks where the question is not what was asked for last, while the dialog is open; stops the work
// when it is not.
void follow_steps(const Ui& ui, const Workspace& work, StepsState& state);

bool is_placing(const StepsState& state);

// The answer to the question as it stands; null while it is being found.
std::shared_ptr<const FoundSteps> current_steps(const Workspace& work, const StepsState& state);

// Puts what lies between the two behind the first of them: one step of undo.
void add_steps(Ui& ui, Workspace& work, const StepsState& state, const FoundSteps& found);

}  // namespace tact
