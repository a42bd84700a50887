// The rhythm's notes on the wave strip: blocks at the bottom of the amplitude lane, taken by their
// edges or as a whole.
//
// Left out  a pattern without a rhythm, which is one note throughout: there is nothing to be taken.
#pragma once

#include "app/wave_strip/grips.h"

namespace tact {

struct NoteBlock {
    std::size_t index = 0;  // of notes(), repetitions of the text included
    Rect area;
};

// Those of which a part is seen.
std::vector<NoteBlock> note_blocks(const Pattern& pattern, const StripScale& scale);

bool is_note(GripKind kind);

// The nearest edge within reach, else the block under the mouse. Over a short one an edge reaches a
// third of the way in.
std::optional<Grip> note_grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                                 float reach_px);

// The rhythm with the grip's note, which all repetitions of the text share, dragged along its grid,
// or `free` along one of quarters of a step.
Rhythm with_note_dragged(const Rhythm& rhythm, const Grip& grip, double by_s, bool free);

// The rhythm with a note of one step where it rests under the mouse; none: not over the blocks'
// row, or it does not rest there.
std::optional<Rhythm> with_note_added(const Pattern& pattern, const StripScale& scale,
                                      ImVec2 mouse);

// The rhythm without the grip's note.
Rhythm with_note_removed(const Rhythm& rhythm, const Grip& grip);

}  // namespace tact
