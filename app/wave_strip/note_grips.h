// The rhythm's notes on the wave strip: blocks at the bottom of the amplitude lane, taken by their
// edges or as a whole.
//
// Left out  a pattern without a rhythm, which is one note throughout: there is nothing to be taken,
//           but a note to be drawn.
#pragma once

#include "app/wave_strip/grips.h"

namespace tact {

struct NoteBlock {
    std::size_t index = 0;  // of notes(), repetitions of the text included
    Rect area;              // at full strength
    float top = 0.0F;       // at the note's own
};

// Those of which a part is seen.
std::vector<NoteBlock> note_blocks(const Pattern& pattern, const StripScale& scale);

bool is_note(GripKind kind);

// The strength that a note would have with its top there, 1/9 to 1.
double strength_at(const StripScale& scale, ImVec2 mouse);

// The nearest edge within reach, else the block under the mouse. Over a short one an edge reaches a
// third of the way in. Of a high one the top, too.
std::optional<Grip> note_grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                                 float reach_px);

// What a dragged note keeps to.
enum class NoteSnap { step, beat, quarter };

NoteSnap snap_of(const GripDrag& drag);
double time_dragged_s(const StripScale& scale, const GripDrag& drag);

// By how many steps of the rhythm a drag moves what was at this step: onto the nearest one, or onto
// the nearest beat.
std::ptrdiff_t steps_moved(const Rhythm& rhythm, std::size_t from, double by_s, NoteSnap snap);

// The rhythm with the grip's note, which all repetitions of the text share, dragged along its grid,
// or along one of quarters of a step.
Rhythm with_note_dragged(const Rhythm& rhythm, const Grip& grip, double by_s, NoteSnap snap);

// The rhythm with the grip's note at this strength, in whole ninths.
Rhythm with_note_strength(const Rhythm& rhythm, const Grip& grip, double strength);

// The rhythm with a note of one step where it rests under the mouse; none: not over the blocks'
// row, or it does not rest there. With the tool of notes anywhere in the lane, and of a pattern
// without a rhythm in one of sixteen steps over its duration.
std::optional<Rhythm> with_note_added(const Pattern& pattern, const StripScale& scale,
                                      ImVec2 mouse);

// The end of the note that begins in the step under the mouse, to be drawn on by a drag.
std::optional<Grip> end_of_note_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse);

// The rhythm without the grip's note.
Rhythm with_note_removed(const Rhythm& rhythm, const Grip& grip);

}  // namespace tact
