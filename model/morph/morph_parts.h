// Parts of a morph: what is between the carriers, the notes and the drawn parts of two patterns.
// Private to the room.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "model/morph/note_warp.h"
#include "model/pattern/pattern.h"

namespace tact {

// Carriers and modulation; none: they cannot change by degrees.
struct MorphedTone {
    std::vector<Carrier> carriers;
    Modulation modulation;
};
std::optional<MorphedTone> tone_between(const Pattern& from, const Pattern& to, double share);

// The gates of two rhythms with their ramps and amplitude curves, as one curve.
AmplitudeCurve notes_between(const Pattern& from, const Pattern& to,
                             const std::vector<WarpedNote>& notes, double share);

// Over the durations as they are at that share.
AmplitudeCurve amplitude_between(const Pattern& from, const Pattern& to, double share);
FrequencyCurve frequency_between(const Pattern& from, const Pattern& to, double share);
std::vector<Transient> transients_between(const Pattern& from, const Pattern& to, double share);

// Two lines over the same stretch as one line between them.
//
// Output    points at every bend of either; where one jumps, two at one place
// Left out  bends of what is between two bent lines by ratio: straight between the points.

// A line over places from 0 to 1.
struct BentLine {
    std::vector<double> bends;           // besides 0 and 1, in any order
    std::function<double(double)> at{};  // its height
};

enum class BlendBy { difference, ratio };

// What is `share` of the way from a to b: 0 is a, 1 is b. By ratio where both are above 0.
double between(double a, double b, double share, BlendBy by);

// Places ascending, from 0 to 1, with heights.
std::vector<std::pair<double, double>> blended(const BentLine& a, const BentLine& b, double share,
                                               BlendBy by);

}  // namespace tact
