// Parts that the files of this room share.
#pragma once

#include <optional>
#include <string>

#include "app/export/export.h"
#include "app/ui/ui.h"

namespace tact {

// How far what is on its way to files is, at the lower right, over the panes: the window keeps
// working.

struct ProgressPlate {
    std::string text;
    std::optional<float> share{};  // 0..1; none: it is not known
    const char* cancel = "Cancel";
    const char* told = "";  // of the button: what is kept
};

// True when it is to be cancelled.
bool draw_progress_plate(Ui& ui, const ProgressPlate& plate);

void draw_export_progress(Ui& ui, ExportState& exports);

// What an export costs, as a pane: words and tables, and the map before and after.
//
// Output    an answer to an earlier question is drawn as stale

void draw_loss_pane(Ui& ui, const Workspace& work, EffectExport& effects, float height_px);

}  // namespace tact
