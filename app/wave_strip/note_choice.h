// Several notes chosen on the strip with the tool of notes, and edits of all of them.
//
// A click chooses a note; with Shift it adds or removes one. A drag on an empty place with Shift
// chooses the notes inside. Moving, strengthening, copying, pasting, doubling and repeating them
// are one step of undo each (model/algebra/chosen_notes.h).
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

inline constexpr int kRepeats = 4;  // of a bar, including the first: the most common number

// Whether notes are chosen in the pattern in the editor, which can be edited.
bool has_chosen_notes(const Workspace& work, const StripState& strip);

// Gives the selected patterns this rhythm, and lengthens those that are too short for it.
void take_rhythm(Workspace& work, const Pattern& before, const Pattern& changed);

// Chooses the note alone, or adds it to those chosen before.
void choose_note(StripState& strip, const Pattern& pattern, std::size_t index);
void toggle_note(StripState& strip, const Pattern& pattern, std::size_t index);

// Chooses the notes inside a box, in whole steps; a box no wider than a click is ignored.
void choose_boxed(StripState& strip, const Pattern& pattern, float click_px);

// A drag of one of several chosen notes moves all; a drag of its top makes all stronger. False:
// only one is chosen.
bool drag_chosen_notes(Ui& ui, Workspace& work, StripState& strip, const GripDrag& drag);

// One step of undo: "Repeat notes of p1".
void commit_notes(Ui& ui, Workspace& work, StripState& strip, const char* verb,
                  const Expected<NotesEdit>& edit);

// Commands for patterns apply to chosen notes first. False: no notes are chosen.
bool copy_notes(Ui& ui, const Workspace& work, const StripState& strip);
bool repeat_notes(Ui& ui, Workspace& work, StripState& strip, int times);
bool remove_notes(Ui& ui, Workspace& work, StripState& strip);
bool choose_all_notes(Ui& ui, const Workspace& work, StripState& strip);

// Pastes a text of steps from the clipboard, at the mouse over the strip or at the playhead. False:
// the clipboard has no steps, or another tool is in use.
bool paste_notes(Ui& ui, Workspace& work, StripState& strip, double playhead_s);

// For keys: chooses the next note, or the one before; after the last comes the first.
void choose_next_note(Ui& ui, StripState& strip, const Pattern& pattern, int step);

}  // namespace tact
