// What the Subset tab marks in the map and in the list.
#pragma once

#include <set>
#include <string>

#include "app/map/map_look.h"
#include "app/window/app.h"

namespace tact {

MapMarks subset_marks(App& app);

// Names of the patterns that are in a pair that is too close, while that is what is shown.
std::set<std::string> too_close_names(const App& app);

}  // namespace tact
