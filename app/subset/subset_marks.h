// What the Subset tab marks in the map and in the list.
#pragma once

#include <set>
#include <string>

#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/subset/subset_state.h"
#include "app/ui/layout.h"

namespace tact {

MapMarks subset_marks(const Theme& theme, const Layout& layout, const ShownMap& shown_map,
                      SubsetState& picking);

// Names of the patterns that are in a pair that is too close, while that is what is shown.
std::set<std::string> too_close_names(const Layout& layout, const SubsetState& picking);

}  // namespace tact
