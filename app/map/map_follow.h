// Keeping the map on screen in step with the document.
#pragma once

#include "app/window/app.h"

namespace tact {

void make_map_jobs(App& app);

// The map of a very large set waits until asked for.
void request_maps(App& app);
// Asks anew where the document has changed since: once a frame, whoever changed it.
void follow_map(App& app);

// Takes what the jobs have finished, aligns it to what is shown and starts the transition.
void take_maps(App& app);

// Puts a map on the screen, aligned to the one before it.
void show_map(App& app, std::shared_ptr<const LiveMap> map);

// What is on screen: is it the document's own, exact map?
enum class MapState {
    none,       // nothing was computed yet, or there is nothing to compute
    too_large,  // the set waits for a word of the person
    exact,
    preview,  // of the document as it is, from coarse envelopes
    stale     // of an earlier document
};
MapState map_state(const App& app);

// Positions of the shown map's patterns in this frame, eased; one row each.
Eigen::MatrixXd eased_points(const App& app);
double ghost_opacity(const App& app);

// Something still moves: frames must follow.
bool is_moving(const App& app);

}  // namespace tact
