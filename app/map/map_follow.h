// Keeping the map on screen in step with the document.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/rendering/rendering_state.h"
#include "app/ui/ui.h"

namespace tact {

// The map of a very large set waits until asked for.
void request_maps(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                  const RenderingState& rendered);
// Asks again if the document has changed since: once a frame, whoever changed it.
void follow_map(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                const RenderingState& rendered);

// Takes what the jobs have finished, aligns it to what is shown and starts the transition.
void take_maps(const Ui& ui, ShownMap& shown_map);

// Keeps with the document where the points of its exact map are, to be saved with it and to lie
// there again after undo.
void note_map_places(Workspace& work, ShownMap& shown_map);

// The ring of the open document, once for each state of it; and which way from its middle a pattern
// lies there, up being positive.
void follow_ring(const Workspace& work, ShownMap& shown_map);
struct RingDirection {
    double right, up;
};
RingDirection ring_direction(const WaitingRing& ring, std::size_t place, std::size_t count);

// Since when the patterns have stood in a ring and waited for their first map, in Ui::ages.
inline constexpr const char* kWaitingRing = "the ring before the first map";

// Puts a map on the screen, aligned to the one before it; the first comes out of that ring.
void show_map(const Ui& ui, ShownMap& shown_map, std::shared_ptr<const LiveMap> map);

// One point goes to `at`, and all others stay where they are, until the next edit.
void hold_places(const Workspace& work, ShownMap& shown_map, Eigen::Index row,
                 const Eigen::RowVectorXd& at);
bool holds_places(const Workspace& work, const ShownMap& shown_map);

// Tells the selection which patterns no receptor answers to, as the shown map has found; of those
// edited since it is not known.
void follow_unfelt(Workspace& work, ShownMap& shown_map);

// What is on screen: is it the document's own, exact map?
enum class MapState {
    none,       // nothing was computed yet, or there is nothing to compute
    too_large,  // the set waits for a word of the person, and is too large for a preview
    exact,
    preview,  // of the present document, from coarse envelopes
    stale     // of an earlier document
};
MapState map_state(const Workspace& work, const ShownMap& shown_map);

// The exact map of so large a set has to be asked for, and was not yet. compute_exact() asks.
bool exact_waits(const Workspace& work, const ShownMap& shown_map);
void compute_exact(const Workspace& work, ShownMap& shown_map);

// Positions of the shown map's patterns in this frame, eased; one row each.
Eigen::MatrixXd eased_points(const Ui& ui, const ShownMap& shown_map);
double ghost_opacity(const Ui& ui, const ShownMap& shown_map);

// Something still moves: frames must follow.
bool is_moving(const Ui& ui, const ShownMap& shown_map);

}  // namespace tact
