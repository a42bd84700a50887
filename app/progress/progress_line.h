// The one way in which a pane tells of work that is under way: "Picking, 40 %, about 20 s left",
// and behind it Cancel.
#pragma once

#include "app/ui/ui.h"

namespace tact {

struct ProgressLine {
    const char* doing;  // "Picking"
    float share = 0.0F;
    const char* cancels;          // "picking": its link is noted as "link:cancel picking"
    const char* word = "Cancel";  // on the link: another one where a dialog has its own Cancel
};

// True when it is to be cancelled. On a line of buttons the words stand as low as theirs.
bool draw_progress(Ui& ui, const ProgressLine& line, bool beside_buttons = false);

}  // namespace tact
