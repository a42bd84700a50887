// What plays: the bar under the menus, the tab and the dialog of devices.
#pragma once

#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_device_panel(App& app);
void draw_devices(App& app);
float transport_height(const App& app);
void draw_transport_bar(App& app, const Rect& area);

// Of the bar: device, level, meter, clip light; without `level` the device alone.
// Without `level` its controls, without `wide` most of the device's name is left out.
struct SoundParts {
    bool level = true;
    bool wide = true;
};
void draw_sound_controls(App& app, SoundParts parts);
float sound_controls_width(const App& app, SoundParts parts);

}  // namespace tact
