// A point of the map is put somewhere else: what its pattern would have to be, or how near it
// comes.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "app/ask/maybes_state.h"
#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// In this frame the point of a pattern is dragged to a place of the map, and perhaps let go there.
struct PointMove {
    std::size_t place = 0;  // of the pattern in the document
    Eigen::RowVectorXd to;
    bool ended = false;
};
void move_point(Ui& ui, const Workspace& work, const ShownMap& shown_map, MaybesState& state,
                const PointMove& move);

// Once a frame: takes what was found as one step of undo, and says how near it came. The place that
// was wanted and the other points stay until the next edit.
void follow_put(Ui& ui, Workspace& work, ShownMap& shown_map, MaybesState& state);
void stop_putting(MaybesState& state);

// What the map shows of it.
void show_put(MapMaybes& shown, Eigen::Index columns, const MaybesState& state);

// "0.8 of 66 from there."
std::string sentence_on(const Reached& reached);

}  // namespace tact
