// Several notes chosen on the strip, with the tool of notes: by the mouse, and what is done with
// all of them.
//
// A click chooses a note, with Shift one more or one less; a drag on the ground with Shift chooses
// what it spans. Moved, strengthened, copied, pasted, doubled and repeated they are one step each
// (model/algebra/chosen_notes.h).
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

inline constexpr int kRepeats = 4;  // of a bar, in all: the commonest

// Whether any is chosen of the pattern in the editor, which may be edited.
bool has_chosen_notes(const Workspace& work, const StripState& strip);

// Puts the patterns that are selected to the rhythm, and to the length where it had to grow.
void take_rhythm(Workspace& work, const Pattern& before, const Pattern& changed);

// The note alone, or with those chosen before.
void choose_note(StripState& strip, const Pattern& pattern, std::size_t index);
void toggle_note(StripState& strip, const Pattern& pattern, std::size_t index);

// What a box spans, to whole steps; nothing where it is no wider than a click.
void choose_boxed(StripState& strip, const Pattern& pattern, float click_px);

// A drag of a note with several chosen moves all, one of its top makes all stronger. False: it is
// one alone.
bool drag_chosen_notes(Ui& ui, Workspace& work, StripState& strip, const GripDrag& drag);

// An edit as one step: "Repeat notes of p1".
void commit_notes(Ui& ui, Workspace& work, StripState& strip, const char* verb,
                  const Expected<NotesEdit>& edit);

// What the commands for patterns do first while notes are chosen. False: they do not.
bool copy_notes(Ui& ui, const Workspace& work, const StripState& strip);
bool repeat_notes(Ui& ui, Workspace& work, StripState& strip, int times);
bool remove_notes(Ui& ui, Workspace& work, StripState& strip);
bool choose_all_notes(Ui& ui, const Workspace& work, StripState& strip);

// The text of steps on the clipboard, at the mouse over the strip or at the playhead. False: there
// is none, or another tool is in use.
bool paste_notes(Ui& ui, Workspace& work, StripState& strip, double playhead_s);

// By keys: the next note, or the one before, round from one end to the other.
void choose_next_note(Ui& ui, StripState& strip, const Pattern& pattern, int step);

}  // namespace tact
