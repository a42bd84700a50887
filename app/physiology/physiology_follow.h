// Keeping the stages on screen in step with the current and the pinned pattern.
#pragma once

#include "app/window/app.h"

namespace tact {

void make_stages_jobs(App& app);
void take_stages(App& app);

// Asks for the stages of the current and of the pinned vibration where they are not those that were
// asked for last.
void follow_current(App& app);

}  // namespace tact
