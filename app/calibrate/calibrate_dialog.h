// Over the window: calibrating the chosen device.
#pragma once

#include "app/calibrate/calibrate_state.h"
#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

void draw_calibrate(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                    PlayState& play, CalibrateState& calibrating);

}  // namespace tact
