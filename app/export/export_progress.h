// How far what is on its way to files is, at the lower right, over the panes: the window keeps
// working.
#pragma once

#include <optional>
#include <string>

#include "app/export/export_state.h"
#include "app/ui/ui.h"

namespace tact {

struct ProgressPlate {
    std::string text;
    std::optional<float> share{};  // 0..1; none: it is not known
    const char* cancel = "Cancel";
    const char* told = "";  // of the button: what is kept
};

// True when it is to be cancelled.
bool draw_progress_plate(Ui& ui, const ProgressPlate& plate);

void draw_export_progress(Ui& ui, ExportState& exports);

}  // namespace tact
