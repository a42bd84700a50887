// Notes of a rhythm that are chosen together: moved, strengthened, copied, pasted and repeated.
//
// A choice counts the steps from the pattern's start on, repetitions of the text included. An edit
// of one repetition alone first writes the text out to the pattern's end. A copy is a text: where
// it is pasted, its letters are notes of the kinds that they are there.
//
// Source    ours
// Input     a pattern without fault, a choice that it has: kept_choice()
// Output    a pattern without fault, which is longer where its notes would not fit; or one sentence
// Left out  quarters of a step: several notes keep to the grid.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/pattern/pattern.h"
#include "model/pattern/rhythm_edit.h"

namespace tact {

struct ChosenNotes {
    std::vector<std::size_t> onsets;  // steps at which they begin, ascending
    NoteSteps span;  // what a copy takes: from the first to the last of them, or a box's steps

    bool empty() const { return onsets.empty(); }
    bool operator==(const ChosenNotes&) const = default;
};

// The steps of all notes of the pattern, ascending.
std::vector<NoteSteps> steps_of_notes(const Pattern& pattern);

// Those that sound within these steps, which are the span.
ChosenNotes notes_within(const Pattern& pattern, const NoteSteps& span);

// The choice with the note that begins there, or without it.
ChosenNotes with_toggled(const Pattern& pattern, const ChosenNotes& chosen, std::size_t onset);

// The choice as far as the pattern has it.
ChosenNotes kept_choice(const Pattern& pattern, const ChosenNotes& chosen);

// The span as a text of steps; notes that are not chosen are rests in it.
std::string copied_notes(const Pattern& pattern, const ChosenNotes& chosen);

struct NotesEdit {
    Pattern pattern;
    ChosenNotes chosen;
};

// The chosen notes moved by a number of steps, or by as many as the text and the pattern have room
// for. A note that they are moved onto keeps its beginning.
Expected<NotesEdit> with_notes_moved(const Pattern& pattern, const ChosenNotes& chosen,
                                     std::ptrdiff_t steps);

// Each note's strength changed by a number of ninths, within one to nine.
Expected<NotesEdit> with_notes_stronger(const Pattern& pattern, const ChosenNotes& chosen,
                                        int ninths);

// Each note's strength changed by a difference, and its pitch by a factor.
Expected<NotesEdit> with_notes_changed(const Pattern& pattern, const ChosenNotes& chosen,
                                       double by_velocity, double by_pitch);

// Each note held for a number of steps, or up to the next note.
Expected<NotesEdit> with_notes_held(const Pattern& pattern, const ChosenNotes& chosen,
                                    std::size_t steps);

Expected<NotesEdit> without_notes(const Pattern& pattern, const ChosenNotes& chosen);

// The text of steps put in the place of what is there; its notes are then chosen.
Expected<NotesEdit> with_notes_pasted(const Pattern& pattern, std::size_t at,
                                      std::string_view text);

// The span repeated `times` times in all, each right after the one before; the last is then chosen.
Expected<NotesEdit> with_notes_repeated(const Pattern& pattern, const ChosenNotes& chosen,
                                        int times);

}  // namespace tact
