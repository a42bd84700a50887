// Pairs that are too close, of the map on screen, and what would separate one of them.
#pragma once

#include "app/subset/subset_state.h"
#include "app/window/app.h"

namespace tact {

const TooClosePairs& too_close_pairs(App& app);

// Opens a pair: it is shown in the other panes, and something may be asked about it.
void open_pair(App& app, const std::string& a, const std::string& b);
// The open one where the map on screen still has it; rows of the map, the first one less.
std::optional<std::pair<std::size_t, std::size_t>> opened_rows(const App& app);

// Why the pattern of a row cannot be changed: "locked", "measured", "removed"; empty: it can.
std::string fixed_because(const App& app, std::size_t row);

// The one of the open pair to be changed: the one chosen, or the only one that may be.
std::size_t row_to_change(const App& app, std::pair<std::size_t, std::size_t> rows);

// What would be asked about it, and why that is impossible now; empty: it is possible.
SeparationRequest separation_request(App& app, std::size_t row);
std::string separation_obstacle(const App& app, std::size_t row);
void ask_for_separation(App& app, std::size_t row);

// The same in one go for a pair of the picked subset.
void ask_about_picked(App& app, const std::string& a, const std::string& b);

// Applies a change as one step.
void apply_separation(App& app, std::size_t place, const Separation& separation);

}  // namespace tact
