// The program's icon, for what shows a window: a burst of vibration, and the points of a space that
// it becomes.
//
// Source    assets/desktop/org.tactspace.Tactspace.svg, which desktops show; of the same shapes.
#pragma once

#include "viz/picture/picture.h"

namespace tact {

// The icon, side x side pixels, transparent around the plate.
Image program_icon(int side);

}  // namespace tact
