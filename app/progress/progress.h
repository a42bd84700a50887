// Work under way and work that failed, as every pane tells of it.
#pragma once

#include <string>

#include "app/ui/ui.h"

namespace tact {

// Why a job that a pane waits for has no answer: said in place of the waiting.

// The sentence at the cursor; false: nothing to say. `pane` is its name for tests.
bool draw_failure(Ui& ui, const char* pane, const std::string& failure);

// The one way in which a pane tells of work that is under way: "Picking, 40 %, about 20 s left",
// and behind it Cancel.

struct ProgressLine {
    const char* doing;  // "Picking"
    float share = 0.0F;
    const char* cancels;          // "picking": its link is noted as "link:cancel picking"
    const char* word = "Cancel";  // on the link: another one where a dialog has its own Cancel
};

// True when it is to be cancelled. On a line of buttons the words stand as low as theirs.
bool draw_progress(Ui& ui, const ProgressLine& line, bool beside_buttons = false);

// How long a run under way will still take, from how far it is: "about 40 s left".
//
// Input     seconds since it began, share done (0 to 1)
// Output    words; empty while too little is known or too little is left to be worth them
// Valid     work that continues at its pace so far

// Rounded up, coarser the longer it is: a number that dances tells less.
std::string time_left_text(double elapsed_s, double share);

// What work will take by a rough estimate, said as one: "about 40 s", "less than 1 s".
std::string estimate_text(double seconds);

}  // namespace tact
