// Names are keys: who holds a pattern by its name has to hear of a new one.
#pragma once

#include <string>

#include "app/document/workspace.h"

namespace tact {

// In the set: its twins, its ratings, its trials, and the choice of those that take part in
// studies.
void rename_in(PatternSet& set, std::size_t index, const std::string& name);

// In what is selected and copied; other rooms find it among the changes.
void follow_rename(Workspace& work, const Renaming& renaming);

// The same for whatever has another name in `after` than in `before`, as by an undo.
void follow_renames(Workspace& work, const PatternSet& before, const PatternSet& after);

}  // namespace tact
