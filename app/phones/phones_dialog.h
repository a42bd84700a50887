// The dialog on phones: the code to scan, who is here, and what they do.
#pragma once

#include "app/document/workspace.h"
#include "app/phones/phones_state.h"
#include "app/play/play_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// What the dialog asks of rooms that it does not know.
struct PhonesActions {
    std::optional<int> trials_on;  // the phone that is to try the closest pairs
    bool rate_together = false;
    bool show_answers = false;  // of the rating, where studies are
};

PhonesActions draw_phones_dialog(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play,
                                 PhonesState& state);

}  // namespace tact
