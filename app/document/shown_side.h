// Which side of a set with measured twins is shown: maps, matrices and what follows are of that
// part.
#pragma once

#include <string>

#include "app/window/app.h"
#include "model/set/measured_twin.h"

namespace tact {

// Changing it makes the maps anew.
Side shown_side(const App& app);
void show_side(App& app, Side side);

// The part of the document that maps are made of.
PatternSet shown_set(const App& app);

// "24 patterns", "12 measured of 24".
std::string shown_patterns_text(const App& app);

}  // namespace tact
