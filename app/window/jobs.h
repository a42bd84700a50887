// The work beside the window, of all rooms: begun, taken and ended together; and begun again where
// another document takes the place of the open one.
#pragma once

#include "app/window/app.h"

namespace tact {

// Starts the jobs, and ends them.
void make_jobs(App& app);
void stop_jobs(App& app);

// Takes what they have finished since the last frame.
void take_answers(App& app);

// Where another document is open than in the frame before, every room begins again: nothing that
// was found, chosen or typed for the one before is shown under the name of the new one. What is the
// person's own stays: looks, layout, devices, which view of a pane is open.
void follow_another_document(App& app);

}  // namespace tact
