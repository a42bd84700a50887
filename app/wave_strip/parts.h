// The rhythm's notes on the wave strip: blocks at the bottom of the amplitude lane, dragged by
// their edges or as a whole.
//
// Left out  a pattern without a rhythm, which is one note throughout: it has no grips, but a note
//           can be drawn.
#pragma once

#include "app/wave_strip/wave_strip.h"

namespace tact {

struct NoteBlock {
    std::size_t index = 0;  // index in notes(), which include repetitions of the text
    Rect area;              // at full strength
    float top = 0.0F;       // at the note's strength
};

// Blocks that are at least partly visible.
std::vector<NoteBlock> note_blocks(const Pattern& pattern, const StripScale& scale);

bool is_note(GripKind kind);

// The strength of a note with its top at the mouse, 1/9 to 1.
double strength_at(const StripScale& scale, ImVec2 mouse);

// The nearest edge within reach, or the block under the mouse. In a short block, an edge reaches a
// third of its width inwards. A high block also has its top.
std::optional<Grip> note_grip_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse,
                                 float reach_px);

// The grid of a dragged note.
enum class NoteSnap { step, beat, quarter };

NoteSnap snap_of(const GripDrag& drag);
double time_dragged_s(const StripScale& scale, const GripDrag& drag);

// The number of steps by which a drag moves the step `from`: to the nearest step, or the nearest
// beat.
std::ptrdiff_t steps_moved(const Rhythm& rhythm, std::size_t from, double by_s, NoteSnap snap);

// The rhythm with the grip's note, in all repetitions of the text, dragged along its grid or along
// quarters of a step.
Rhythm with_note_dragged(const Rhythm& rhythm, const Grip& grip, double by_s, NoteSnap snap);

// The rhythm with the grip's note at this strength, rounded to ninths.
Rhythm with_note_strength(const Rhythm& rhythm, const Grip& grip, double strength);

// The rhythm with a one-step note at the rest under the mouse; nullopt if the mouse is outside the
// blocks' row or on a note. The tool of notes accepts the whole lane, and divides a pattern without
// a rhythm into sixteen steps.
std::optional<Rhythm> with_note_added(const Pattern& pattern, const StripScale& scale,
                                      ImVec2 mouse);

// The end of the note that begins in the step under the mouse, so that a drag continues drawing it.
std::optional<Grip> end_of_note_at(const Pattern& pattern, const StripScale& scale, ImVec2 mouse);

// The rhythm without the grip's note.
Rhythm with_note_removed(const Rhythm& rhythm, const Grip& grip);

}  // namespace tact
