// Rhythm as text on a grid: x starts a note, 1 to 9 a note of that many ninths of its strength, A
// to Z a note of a kind of its own, = holds it, - rests.
//
// A kind has any strength and a pitch, which the carriers' frequencies are multiplied by from the
// note's onset to the next one's. A letter without a kind is the whole note, as x is.
//
// Source    the notation is ours. Evenness: the first Fourier coefficient of the onsets on a circle
//           (Amiot 2009; Milne, Bulger & Herff 2017).
// Valid     at most kMaxRhythmSteps characters; `=` not after `-`, nor first; 26 kinds
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/units.h"

namespace tact {

// Room for 10,000 notes with rests between them; a text of a file may be as long.
inline constexpr std::size_t kMaxRhythmSteps = 20'000;

namespace limits {
inline constexpr Range kVelocity{0.0, 1.0};
inline constexpr Range kPitch{0.1, 10.0};
inline constexpr Range kStepsABeat{1.0, 24.0};
inline constexpr Range kBeatsABar{0.0, 32.0};
}  // namespace limits

// What a letter stands for.
struct NoteKind {
    double velocity = 1.0;  // factor of the pattern's amplitude
    double pitch = 1.0;     // factor of the carriers' frequencies

    bool operator==(const NoteKind&) const = default;
};

// How steps are counted as music: nothing that sounds depends on it.
struct Meter {
    int steps_a_beat = 4;
    int beats_a_bar = 0;  // 0: no bars

    bool operator==(const Meter&) const = default;
};

struct Rhythm {
    std::string text;  // empty: one note throughout
    double unit_s = 0.125;
    std::map<char, NoteKind> kinds{};  // by letter
    Meter meter{};

    bool operator==(const Rhythm&) const = default;
};

struct Note {
    double onset_s = 0.0;
    double length_s = 0.0;
    double velocity = 1.0;  // factor of the pattern's amplitude
    double pitch = 1.0;     // factor of the carriers' frequencies

    bool operator==(const Note&) const = default;
};

// Whether a mark starts a note, and whether that note is of a kind of its own.
inline bool is_letter(char mark) { return mark >= 'A' && mark <= 'Z'; }
inline bool starts_note(char mark) {
    return mark == 'x' || (mark >= '1' && mark <= '9') || is_letter(mark);
}

// How strong and how high a note is that the mark starts.
NoteKind kind_of(const Rhythm& rhythm, char mark);

// The mark of the nearest velocity among x and the digits; of the whole one x.
char note_mark(double velocity);

// The mark of such a note: x or a digit that says it exactly, else a letter of that kind, else the
// first one that the text does not use, which then has it. None: all are in use.
std::optional<char> mark_for(Rhythm& rhythm, const NoteKind& kind);

// Whether any note of the text has another pitch than 1.
bool has_pitches(const Rhythm& rhythm);

// The other rhythm's text with letters that mean here what they mean there; their kinds are added.
// None: there are not as many letters.
std::optional<std::string> text_with_kinds_of(Rhythm& rhythm, const Rhythm& other);

// What is wrong with the text as a rhythm, as the end of a sentence ("step 3 is 'q', expected x, =
// or -"); empty if it is one.
std::string rhythm_fault(std::string_view text);

// The notes of a pattern, in order. The text repeats to fill the duration and the last note is
// cut there. Asserts that the text has no fault.
std::vector<Note> notes(const Rhythm& rhythm, double duration_s);

// The note that sounds at a time, none in a rest and outside of the pattern.
std::optional<Note> note_at(const Rhythm& rhythm, double duration_s, double t_s);

// The pitch that the carriers have at a time: of the last note that began, before the first one
// its.
double pitch_at(const Rhythm& rhythm, double t_s);

// Steps at which notes start, ascending.
std::vector<std::size_t> onsets(std::string_view text);

// |sum_j exp(2 pi i (onset_j / steps - j / notes))| / notes: 1 where all notes are equally far
// apart, as the text repeats; 0 of no notes. Lengths of notes do not matter.
double evenness(std::string_view text);

// The text with a note from step `first` held to step `last`, with the strength of one that begins
// there. The beginning of a note that it cuts stays. Asserts that first <= last < steps.
std::string with_note(std::string text, std::size_t first, std::size_t last);

// Rhythms by the list: all there are of a length, and the most even ones.
//
// A necklace is a rhythm up to rotation. The list has the rotation that begins with a note and has
// the longest gaps first: x--x--x- stands for its eight rotations.
//
// Source    necklaces: Fredricksen & Maiorana 1978, recursion of Ruskey, Savage & Wang 1992; their
//           number: Burnside's lemma. Euclidean rhythms: Bjorklund 2003, Toussaint 2005.
// Output    texts as a Rhythm has them; every note one step long until with_note_length()
// Valid     1 to kMostListSteps steps, 1 to as many notes

inline constexpr std::size_t kMostListSteps = 24;

// Number of necklaces of n steps with k notes: (1/n) sum_{d | gcd(n, k)} phi(d) C(n/d, k/d). 0 for
// no steps, more notes than steps or more than kMostListSteps steps.
std::uint64_t necklace_count(std::size_t steps, std::size_t notes);

// All of them, longest gaps first; none where necklace_count() is 0, or of no notes.
std::vector<std::string> necklaces(std::size_t steps, std::size_t notes);

// The notes as evenly on the steps as whole steps allow, longest gaps where Bjorklund's algorithm
// puts them: E(3, 8) is x--x--x-. Empty where there are no notes or more notes than steps.
std::string euclidean_rhythm(std::size_t steps, std::size_t notes);

// The text with every note held for `steps` steps, or up to the next note or the end of the text
// where that comes first; 0 holds every note as long as it can be. Asserts that the text is a
// rhythm.
std::string with_note_length(std::string text, std::size_t steps);

}  // namespace tact
