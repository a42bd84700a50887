// What a list of generated rhythms is left at, and the drag that draws a note.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

enum class RhythmList {
    necklaces,  // all of a length and number of notes
    euclidean   // the most even one of every number of notes
};

struct RhythmChoice {
    RhythmList list = RhythmList::necklaces;
    int steps = 8;
    int notes = 3;
    int note_steps = 1;  // length of a note; 0: held up to the next

    std::vector<std::string> texts;  // of these; made anew when they change, most even first
    std::optional<RhythmList> made_list;
    int made_steps = 0;
    int made_notes = 0;
    int made_note_steps = 0;

    Pattern previewed;  // whose envelope is kept
    std::vector<double> envelope;
};

// From the pressed step of the grid to the one under the mouse.
struct NoteDrag {
    std::string before;  // the whole text
    std::size_t from = 0;
    bool moved = false;
};

}  // namespace tact
