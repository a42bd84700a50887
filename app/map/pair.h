// The two patterns that are held against each other.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "app/document/workspace.h"
#include "app/map/map_state.h"

namespace tact {

// The current pattern and the one it is held against.
enum class PartnerKind { chosen, pinned, closest };
struct ChosenPair {
    std::size_t current = 0;
    std::size_t partner = 0;
    PartnerKind kind = PartnerKind::chosen;
};

// The pair chosen by a click, then the pinned one, then the closest by PM. Empty with fewer than
// two patterns.
std::optional<ChosenPair> chosen_pair(const Workspace& work, const ShownMap& shown_map);

// The current pattern and the closest one by PM, whatever was chosen.
std::optional<ChosenPair> closest_pair(const Workspace& work, const ShownMap& shown_map);

// Their rows in the map on screen, which there must be; none where it leaves one of them out.
std::optional<std::pair<std::size_t, std::size_t>> rows_in_map(const Workspace& work,
                                                               const ShownMap& shown_map,
                                                               const ChosenPair& pair);

}  // namespace tact
