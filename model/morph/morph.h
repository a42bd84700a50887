// A pattern between two patterns: the straight path of their parameters, and of rhythms that differ
// the way by which their notes warp into each other.
//
// Amplitudes, frequencies and the rhythm's unit go by ratio where both are above 0, all else by
// difference. Carriers are taken in their order; one that the other has not gains its weight on the
// way. Between no modulation and one that multiplies, or between the two kinds, the carriers give
// their strength to the two side bands that the modulation consists of, by degrees.
//
// Source    ours. Trigonometry: sin a sin b = (sin(b - a + pi/2) + sin(b + a - pi/2)) / 2.
// Output    at 0 and 1 the two patterns themselves, bit for bit; between rhythms that differ the
//           notes are drawn, as an amplitude curve, since a rhythm has no notes of other strengths
// Left out  what morph_jumps() names, which changes at half of the way.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/morph/note_warp.h"
#include "model/pattern/pattern.h"

namespace tact {

// The way from one to the other: their notes are matched once, for all places of it.
class Morph {
  public:
    Morph(const Pattern& from, const Pattern& to);
    Pattern at(double share) const;  // of the way, 0 to 1

  private:
    void set_rhythm(Pattern& pattern, double share) const;

    std::array<Pattern, 2> ends_;
    Pattern from_;  // with pitches in its frequency curve where the rhythms differ
    Pattern to_;
    bool same_rhythm_;
    // The notes of both rhythms, where these differ; none where there are too many.
    std::optional<std::vector<WarpedNote>> notes_;
};

// One place of it.
Pattern morphed(const Pattern& from, const Pattern& to, double share);

// What cannot change by degrees between these two, as the beginning of a sentence each ("the
// modulation"); empty: nothing.
std::vector<std::string> morph_jumps(const Pattern& from, const Pattern& to);

// A pattern among up to four: the corners of a square, and a place in it.
//
// Source    ours: model/morph, first along the upper and the lower edge, then between the two
// Input     corners upper left, upper right, lower left, lower right, of which the last or the last
//           two may be missing: then the lower edge is its left corner, or the same as the upper
// Output    at a corner that pattern itself, bit for bit
// Left out  what morph_jumps() names, which changes at half of the way; rhythms of four corners are
//           warped along the edges alone: between the edges their drawn notes fade

inline constexpr std::size_t kMostCorners = 4;

// `right` and `down` from the upper left corner, 0 to 1. At least one corner.
Pattern mixed_among(const std::vector<Pattern>& corners, double right, double down);

}  // namespace tact
