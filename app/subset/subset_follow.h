// Keeping the picked subset, and what is asked about it, in step with the document.
#pragma once

#include "app/subset/subset_state.h"
#include "app/window/app.h"

namespace tact {

void make_subset_jobs(App& app);
// What is shown of it, without its jobs: for a picture.
std::shared_ptr<SubsetState> still_subset(const SubsetState& state);

void stop_subset_jobs(App& app);

// Takes what the jobs have finished; asks anew where the document or the question has changed.
void follow_subset(App& app);

// The subset on screen, of the map on screen; null: none. It may answer an earlier question ...
const Pick* shown_pick(const App& app);
// ... and then is not that of the document as it is.
bool is_pick_stale(const App& app);
// The best one, or the alternative that is looked at.
const Subset* shown_subset(const App& app);
bool is_picking(const App& app);
bool is_subset_busy(const App& app);  // with anything
void cancel_picking(App& app);

// The share of draws, where the shown subset's was computed.
const Stability* shown_stability(const App& app);

}  // namespace tact
