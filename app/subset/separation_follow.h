// Pairs that are too close, of the map on screen, and what would separate one of them.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/subset/subset_state.h"
#include "app/ui/ui.h"

namespace tact {

const TooClosePairs& too_close_pairs(const ShownMap& shown_map, SubsetState& picking);

// Opens a pair: it is shown in the other panes, and something may be asked about it.
void open_pair(Workspace& work, SubsetState& picking, const std::string& a, const std::string& b);
// The open one where the map on screen still has it; rows of the map, the first one less.
std::optional<std::pair<std::size_t, std::size_t>> opened_rows(const ShownMap& shown_map,
                                                               const SubsetState& picking);

// Why the pattern of a row cannot be changed: "locked", "measured", "removed"; empty: it can.
std::string fixed_because(const Workspace& work, const ShownMap& shown_map, std::size_t row);

// The one of the open pair to be changed: the one chosen, or the only one that may be.
std::size_t row_to_change(const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking, std::pair<std::size_t, std::size_t> rows);

// What would be asked about it, and why that is impossible now; empty: it is possible.
SeparationRequest separation_request(const ShownMap& shown_map, SubsetState& picking,
                                     std::size_t row);
std::string separation_obstacle(const Workspace& work, const ShownMap& shown_map,
                                const SubsetState& picking, std::size_t row);
void ask_for_separation(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        SubsetState& picking, std::size_t row);

// The same in one go for a pair of the picked subset.
void ask_about_picked(const Ui& ui, Workspace& work, const ShownMap& shown_map,
                      SubsetState& picking, const std::string& a, const std::string& b);

// And for any pair, by what counts as too close now; the first of them is to be changed.
void ask_about_pair(const Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
                    const std::string& a, const std::string& b);

// Whether the two are listed as too close.
bool is_listed(const TooClosePairs& pairs, const std::string& a, const std::string& b);

// Says of an applied change, once the map is exact, whether the pair is still listed.
void check_applied(Ui& ui, const Workspace& work, const ShownMap& shown_map, SubsetState& picking);

// Applies a change as one step.
void apply_separation(Ui& ui, Workspace& work, std::size_t place, const Separation& separation);

}  // namespace tact
