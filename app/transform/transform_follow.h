// Edits of the selected patterns: asking for them, and taking them into the set.
#pragma once

#include <memory>
#include <string>

#include "app/document/workspace.h"
#include "app/transform/transform_state.h"
#include "app/ui/ui.h"

namespace tact {

void open_transform(Ui& ui, const Workspace& work, TransformState& state);

// Why nothing can be transformed, as a sentence; empty: something can.
std::string transform_obstacle(const Workspace& work, const TransformState& state);

// "buzz", "3 patterns", and how many of the selected ones stay unchanged.
std::string transformed_words(const Workspace& work);

// Asks where the question is not what was asked for last, while the dialog is open; stops the work
// when it is not.
void follow_transform(const Ui& ui, const Workspace& work, TransformState& state);

bool is_transforming(const TransformState& state);

// The answer to the question as it stands; null while it is being made.
std::shared_ptr<const Transformed> current_transform(const Workspace& work,
                                                     const TransformState& state);

// Whether any of the patterns could be edited.
bool can_be_applied(const Transformed& made);

// Puts the patterns in the place of the selected ones: one step of undo.
void apply_transform(Ui& ui, Workspace& work, const TransformState& state, const Transformed& made);

}  // namespace tact
