// How a map lies: distances say nothing of where up is, so a new map is turned onto an earlier one.
//
// Left out  what is shown of either (map_follow.h)
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/map/map_state.h"

namespace tact {

// Rows of the vibrations that two maps have in common, by name.
struct Common {
    std::vector<Eigen::Index> here;
    std::vector<Eigen::Index> there;
};

Common common_rows(const LiveMap& map, const LiveMap& earlier);

// As it was saved with the set: rows of this map, and where those were.
struct SavedPlaces {
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd points;
};

SavedPlaces saved_places(const LiveMap& map, const MapPlaces& kept);

// Rows of `points` onto the rows of `target`, and all others with them.
Eigen::MatrixXd turned_onto(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& rows,
                            const Eigen::MatrixXd& target);

// Fewer points in common tell no turn.
bool tells_turn(std::size_t common, Eigen::Index dimensions);

// Aligned to how the same set lay before, or to the last exact map; before this document has one,
// to its saved map, or to the preview on screen.
Eigen::MatrixXd aligned_to_anchor(const MapTransition& map, const LiveMap& fresh);

// The anchor's points, row by row of `map`; NaN for patterns that it has not.
Eigen::MatrixXd ghosts_of(const LiveMap& map, const MapTransition& anchored);

}  // namespace tact
