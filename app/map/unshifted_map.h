// Where the points were before thresholds were shifted or a receptor type was removed: ghosts,
// until the thresholds are the program's again.
//
// Output    an anchor of the map on screen whose thresholds are the program's; if none was ever
//           shown, such as for a set that was opened so or edited since, it is made in the
//           background
// Left out  sets whose maps wait for a word
#pragma once

#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

inline constexpr const char* kUnshiftedText = "Rings: with the thresholds as they come";

// Whether `fresh` leaves the anchor as it is: previews do, and maps of shifted thresholds where it
// has none.
bool keeps_anchor(const MapTransition& before, const LiveMap& fresh);

// The anchor is the map on screen but for its thresholds, which are shifted.
bool shows_unshifted(const MapTransition& map);

// Once a frame: asks for the map without shifts, and takes it.
void follow_unshifted(const Ui& ui, ShownMap& shown_map);

}  // namespace tact
