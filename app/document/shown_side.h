// Which side of a set with measured twins is shown: maps, matrices and what follows are of that
// part.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "model/set/measured_twin.h"

namespace tact {

// Changing it makes the maps again.
Side shown_side(const Workspace& work);
void show_side(Workspace& work, Side side);

// The part of the document that maps are made of.
PatternSet shown_set(const Workspace& work);

// "1 pattern", "12 patterns".
std::string patterns_text(std::size_t count);

// "24 patterns", "12 measured of 24".
std::string shown_patterns_text(const Workspace& work);

}  // namespace tact
