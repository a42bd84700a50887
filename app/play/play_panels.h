// Panels of playing: the bar under the menus, the tab and the dialog of devices.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// The report uses the bar's level if it describes the present playback.
void follow_level(Workspace& work, RenderingState& rendered, const PlayState& play);

void draw_device_panel(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                       const PlayState& play);
void draw_devices(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play);
float transport_height(const Ui& ui);
void draw_transport_bar(Ui& ui, Workspace& work, Timeline& timeline, ShownMap& shown_map,
                        const RenderingState& rendered, PlayState& play, const Rect& area);

// Part of the bar: device, level, meter, clip light. Without `meter`, meter and light are left out;
// without `wide`, most of the device's name. The level is always there.
struct SoundParts {
    bool meter = true;
    bool wide = true;
};
void draw_sound_controls(Ui& ui, Timeline& timeline, PlayState& play, SoundParts parts);
float sound_controls_width(const Ui& ui, const PlayState& play, SoundParts parts);

}  // namespace tact
