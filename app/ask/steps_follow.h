// Even steps between two patterns of the set: the question, and adding its answer to the set.
#pragma once

#include <memory>
#include <string>

#include "app/ask/steps_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Opens the dialog on these two names; if empty: the pattern in the editor and its partner, or the
// pattern after it.
void open_steps(Ui& ui, const Workspace& work, StepsState& state, const std::string& from,
                const std::string& to);

// The reason why the question cannot be asked, a sentence; empty if it can.
std::string steps_obstacle(const Workspace& work, const StepsState& state);
std::optional<StepsRequest> steps_request(const Workspace& work, const StepsState& state);

// Asks if the question differs from the last one and the dialog is open; stops the work when the
// dialog closes.
void follow_steps(const Ui& ui, const Workspace& work, StepsState& state);

bool is_placing(const StepsState& state);

// The answer to the current question; null until it is found.
std::shared_ptr<const FoundSteps> current_steps(const Workspace& work, const StepsState& state);

// Adds the patterns between the two behind the first of them: one step of undo.
void add_steps(Ui& ui, Workspace& work, const StepsState& state, const FoundSteps& found);

}  // namespace tact
