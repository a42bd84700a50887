// The map itself: what of the document it shows, and what the person does in it.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <utility>

#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_rows.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// What the person did in the map, for the frame to act on: rows of the document.
struct SpacePaneAction {
    std::optional<std::size_t> hovered{};
    std::optional<std::size_t> double_clicked{};
    // Alt+drag of a point: its place in the document, where to in the map, and whether it is let
    // go.
    std::optional<std::size_t> moved{};
    Eigen::RowVectorXd moved_to{};
    bool move_ended = false;
    std::optional<Eigen::RowVectorXd> placed_at{};  // where marks take a place
    std::optional<std::size_t> menu_asked{};        // of this point
    std::optional<std::size_t> proposal_pressed{};  // of the marks' proposals
    std::optional<std::size_t> proposal_clicked{};
    std::optional<std::pair<std::size_t, std::size_t>>
        drawn_between{};  // Ctrl+drag, first to second
};

// `places` are those of the rows of the map on screen, which there must be. A click selects, with
// Ctrl too; the rest is for the frame.
SpacePaneAction draw_space_scene(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks, const RowPlaces& places, const Rect& area);

}  // namespace tact
