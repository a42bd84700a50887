// The rows of the map on screen as places in the document, which may have been edited since.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map_state.h"

namespace tact {

// Place of every row of the map; empty: the pattern is gone, or has another name.
using RowPlaces = std::vector<std::optional<std::size_t>>;

// There must be a map.
RowPlaces places_in_document(const Workspace& work, const ShownMap& shown_map);

// The map on screen is of another document, or not one of its patterns is left in this one: it says
// nothing of that. Without a map: false.
bool shows_another_set(const Workspace& work, const ShownMap& shown_map);

// The rows of what is selected beside the current pattern, in ascending order.
std::vector<std::size_t> rows_selected_too(const Workspace& work, const RowPlaces& places);

}  // namespace tact
