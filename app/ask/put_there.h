// Moving a point of the map: the search for the pattern that belongs to its new place, or comes
// nearest to it.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "app/ask/proposals_state.h"
#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// Records that the mouse drags the point of a pattern in this frame, and whether it was released.
struct PointMove {
    std::size_t place = 0;  // the dragged pattern, in the document
    Eigen::RowVectorXd to;
    bool ended = false;
};
void move_point(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
                const PointMove& move);

// Once a frame: puts the found pattern into the set as one step of undo, and reports its distance
// from the target. The target and the other points stay on screen until the next edit.
void follow_put(Ui& ui, Workspace& work, ShownMap& shown_map, ProposalsState& state);
void stop_putting(ProposalsState& state);

// The part of it that the map shows.
void show_put(MapMaybes& shown, Eigen::Index columns, const ProposalsState& state);

// "0.8 of 66 from there."
std::string sentence_on(const Reached& reached);

}  // namespace tact
