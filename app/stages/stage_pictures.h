// Stages that are not signals over time: spectrum, receptor grids, raster and relay networks.
#pragma once

#include "app/stages/stage_views.h"

namespace tact {

void draw_spectrum_stage(Ui& ui, Physiology& physiology, const ShownStages& shown, const Rect& area,
                         bool large);
void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size);
// Legend of the maps' colours and marks, in the bottom line of large maps.
void draw_receptor_key(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                       const Rect& line);
void draw_spike_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, const Rect& area, const StageSize& size);
void draw_network_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                        const ShownStages& shown, const Rect& area, const StageSize& size);

// The same for networks.
void draw_network_key(const Ui& ui, const ShownStages& shown, const Rect& line);

// Width of the switch between maps from above and tilted ones, the control of the receptors' stage.
float view_choice_px(const Ui& ui);

}  // namespace tact
