// State of the list of generated rhythms, and the drag that draws a note.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

enum class RhythmList {
    necklaces,  // all of one length and number of notes
    euclidean   // the most even one for each number of notes
};

struct RhythmChoice {
    RhythmList list = RhythmList::necklaces;
    int steps = 8;
    int notes = 3;
    int note_steps = 1;  // length of a note; 0: held until the next

    std::vector<std::string> texts;  // rhythms for these settings, computed when the settings
                                     // change, most even first
    std::optional<RhythmList> made_list;
    int made_steps = 0;
    int made_notes = 0;
    int made_note_steps = 0;

    Pattern previewed;  // the rhythm with the kept envelope
    std::vector<double> envelope;
};

// A note from the pressed step of the grid to the step under the mouse.
struct NoteDrag {
    std::string before;  // the whole text before the drag
    std::size_t from = 0;
    bool moved = false;
};

}  // namespace tact
