// How large a map is in its pane, and what is in the middle of that; see space_camera.h. Private to
// the camera.
#pragma once

#include "viz/space/space_camera.h"

namespace tact {

// Pixels of one radius at zoom 1, and what of X and Y is in the middle of the pane.
struct Framing {
    double radius_px;
    double across = 0.0;
    double middle = 0.0;
};

Framing framed(const SpaceCamera& camera, const SpaceFit& fit, const Rect& pane);

// What the camera sees of the outer points.
SeenExtent seen_extent(const SpaceCamera& camera, const SpaceFit& fit);

}  // namespace tact
