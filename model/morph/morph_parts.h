// Parts of a morph: what is between the carriers, the notes and the drawn parts of two patterns.
// Private to the room.
#pragma once

#include <optional>
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

}  // namespace tact
