// Background jobs of all rooms: collected together, and begun again for another document.
#pragma once

#include "app/window/app.h"

namespace tact {

// Collects the results since the last frame.
void collect_results(App& app);

// If another document is open than in the frame before, every room is reset: no result, selection
// or text of the old document appears under the name of the new one. Settings of the person stay:
// looks, layout, devices, the open tabs.
void follow_another_document(App& app);

}  // namespace tact
