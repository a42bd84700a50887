// Keeping the map on screen in step with the document.
#pragma once

#include "app/window/app.h"

namespace tact {

// Starts the jobs, and ends them; the map of a very large set waits until asked for.
void make_jobs(App& app);
void stop_jobs(App& app);
void request_maps(App& app);
// All that is predicted is asked for anew, though the document stays what it is.
void predictions_changed(App& app);

// Takes what the jobs have finished, aligns it to what is shown and starts the transition.
void take_answers(App& app);

// Asks for the stages of the current and of the pinned vibration where they are not those that were
// asked for last.
void follow_current(App& app);

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
