// The stages that are no signals over time: spectrum, receptor grids, raster and relay networks.
#pragma once

#include "app/stages/stage_views.h"

namespace tact {

void draw_spectrum_stage(Ui& ui, Physiology& physiology, const ShownStages& shown, const Rect& area,
                         bool large);
void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size);
// What the maps' colours and marks stand for, on the line at the foot of the large ones.
void draw_receptor_key(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                       const Rect& line);
void draw_spike_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, const Rect& area, const StageSize& size);
void draw_network_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                        const ShownStages& shown, const Rect& area, const StageSize& size);

// The same of the networks.
void draw_network_key(const Ui& ui, const ShownStages& shown, const Rect& line);

// Of the choice between maps from above and tilted ones: the controls of the receptors' stage.
float view_choice_px(const Ui& ui);

}  // namespace tact
