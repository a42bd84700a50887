// What all rooms lay over the map.
#pragma once

#include "app/map/map_look.h"
#include "app/window/app.h"

namespace tact {

MapMarks map_marks(App& app);

}  // namespace tact
