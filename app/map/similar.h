// Who is most like a pattern: the closest in the map by PM.
#pragma once

#include <cstddef>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

inline constexpr std::size_t kSimilarOnes = 5;

// Selects the pattern at a place of the document and the closest to it, and says how far they are.
void select_similar(Ui& ui, Workspace& work, const ShownMap& shown_map, std::size_t place);

}  // namespace tact
