// Rhythm as text on a grid: x starts a note, = holds it, - rests.
//
// Source    the notation is ours. Evenness: the first Fourier coefficient of the onsets on a circle
//           (Amiot 2009; Milne, Bulger & Herff 2017).
// Valid     at most kMaxRhythmSteps characters; `=` only after `x` or `=`
// Left out  dynamics within a rhythm: every note has the pattern's amplitude.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

inline constexpr std::size_t kMaxRhythmSteps = 256;

struct Rhythm {
    std::string text;  // empty: one note throughout
    double unit_s = 0.125;

    bool operator==(const Rhythm&) const = default;
};

struct Note {
    double onset_s = 0.0;
    double length_s = 0.0;

    bool operator==(const Note&) const = default;
};

// Empty where the text is a rhythm; else what is wrong with it, as the end of a sentence
// ("step 3 is 'q', expected x, = or -").
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

// The text with a note from step `first` held to step `last`. Of a note that it cuts, the beginning
// stays. Asserts that first <= last < steps.
std::string with_note(std::string text, std::size_t first, std::size_t last);

}  // namespace tact
