// The work beside the window, of all rooms: begun, taken and ended together.
#pragma once

#include "app/window/app.h"

namespace tact {

// Starts the jobs, and ends them.
void make_jobs(App& app);
void stop_jobs(App& app);

// Takes what they have finished since the last frame.
void take_answers(App& app);

}  // namespace tact
