// What an export costs, as a pane: words and tables, and the map before and after.
//
// Output    an answer to an earlier question is drawn as stale
#pragma once

#include "app/export/effect_export.h"

namespace tact {

void draw_loss_pane(Ui& ui, const Workspace& work, EffectExport& effects, float height_px);

}  // namespace tact
