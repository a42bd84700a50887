// Notes of a rhythm's text, moved on its grid.
//
// Input     text without fault (model/pattern/rhythm.h)
// Output    text without fault: a note keeps off its neighbours and within the text
// Left out  notes across the end of the text: it repeats, and none is held from there on.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/pattern/rhythm.h"

namespace tact {

// The first and the last step of a note.
struct NoteSteps {
    std::size_t first = 0;
    std::size_t last = 0;

    bool operator==(const NoteSteps&) const = default;
};

// In their order.
std::vector<NoteSteps> note_steps(std::string_view text);

enum class NotePart { start, whole, end };

// The text with a part of its k-th note moved by `steps`, or as far as there is room: a note keeps
// at least one step. Asserts that there is such a note.
std::string with_note_moved(std::string text, std::size_t k, NotePart part, std::ptrdiff_t steps);

// The text with rests for its k-th note. Asserts that there is such a note.
std::string without_note(std::string text, std::size_t k);

// Beats a minute; and the step at a tempo.
double tempo_bpm(double unit_s, int steps_a_beat);
double unit_at_tempo(double bpm, int steps_a_beat);

// Steps of a bar; 0: it has none.
std::size_t steps_a_bar(const Meter& meter);

// The meter for steps of another length: a beat lasts as long where that is a whole number of them.
Meter with_step(Meter meter, double from_s, double to_s);

// How long the text lasts once; 0 s where it is empty.
double length_s(const Rhythm& rhythm);

// The same rhythm with every step as `by` of them; as it is where that would be more than a text
// or shorter than a step may be.
Rhythm refined(const Rhythm& rhythm, std::size_t by);

// The same rhythm with as many steps made one, up to `by`, as each note allows.
Rhythm coarsened(const Rhythm& rhythm, std::size_t by);

}  // namespace tact
