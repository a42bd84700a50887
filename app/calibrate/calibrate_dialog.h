// Over the window: calibrating the chosen device.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_calibrate(App& app);

}  // namespace tact
