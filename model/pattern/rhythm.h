// Rhythm as text on a grid: x starts a note, 1 to 9 a note of that many ninths of its strength, =
// holds it, - rests.
//
// Source    the notation is ours. Evenness: the first Fourier coefficient of the onsets on a circle
//           (Amiot 2009; Milne, Bulger & Herff 2017).
// Valid     at most kMaxRhythmSteps characters; `=` not after `-`, nor first
// Left out  a pitch of a single note.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

// Room for 10,000 notes with rests between them; a text of a file may be as long.
inline constexpr std::size_t kMaxRhythmSteps = 20'000;

struct Rhythm {
    std::string text;  // empty: one note throughout
    double unit_s = 0.125;

    bool operator==(const Rhythm&) const = default;
};

struct Note {
    double onset_s = 0.0;
    double length_s = 0.0;
    double velocity = 1.0;  // factor of the pattern's amplitude, 1/9 to 1

    bool operator==(const Note&) const = default;
};

// Whether a mark starts a note, and how strong that note is.
inline bool starts_note(char mark) { return mark == 'x' || (mark >= '1' && mark <= '9'); }
inline double velocity_of(char mark) { return mark == 'x' ? 1.0 : (mark - '0') / 9.0; }

// The mark of the nearest velocity; of the whole one x.
char note_mark(double velocity);

// What is wrong with the text as a rhythm, as the end of a sentence ("step 3 is 'q', expected x, =
// or -"); empty if it is one.
std::string rhythm_fault(std::string_view text);

// The notes of a pattern, in order. The text repeats to fill the duration and the last note is
// cut there. Asserts that the text has no fault.
std::vector<Note> notes(const Rhythm& rhythm, double duration_s);

// The note that sounds at a time, none in a rest and outside of the pattern.
std::optional<Note> note_at(const Rhythm& rhythm, double duration_s, double t_s);

// Steps at which notes start, ascending.
std::vector<std::size_t> onsets(std::string_view text);

// |sum_j exp(2 pi i (onset_j / steps - j / notes))| / notes: 1 where all notes are equally far
// apart, as the text repeats; 0 of no notes. Lengths of notes do not matter.
double evenness(std::string_view text);

// The text with a note from step `first` held to step `last`, with the strength of one that begins
// there. The beginning of a note that it cuts stays. Asserts that first <= last < steps.
std::string with_note(std::string text, std::size_t first, std::size_t last);

}  // namespace tact
