// Rhythms by the list: all there are of a length, and the most even ones.
//
// A necklace is a rhythm up to rotation. The list has the rotation that begins with a note and has
// the longest gaps first: x--x--x- stands for its eight rotations.
//
// Source    necklaces: Fredricksen & Maiorana 1978, recursion of Ruskey, Savage & Wang 1992; their
//           number: Burnside's lemma. Euclidean rhythms: Bjorklund 2003, Toussaint 2005.
// Output    texts of model/pattern/rhythm.h; every note one step long until with_note_length()
// Valid     1 to kMostListSteps steps, 1 to as many notes
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace tact {

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
