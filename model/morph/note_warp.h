// Which notes of one rhythm become which of another: the way by which they warp into each other.
//
// A note becomes a note, several (it splits), or a part of one (they melt). The rhythm with more
// notes may have some that fade, the other one never: where one note goes, none comes in its place,
// as both would be felt faintly on the way, like ghosts.
//
// Source    dynamic time warping over notes instead of samples (Sakoe & Chiba 1978), with a cost of
//           our own: how far ends of notes move, the gaps that open or close, and for a note that
//           fades its length and a tenth of the pattern, all as shares of the durations.
// Valid     at most kMostWarpedNotes notes on either side
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/pattern/rhythm.h"

namespace tact {

inline constexpr std::size_t kMostWarpedNotes = 120;

// What sounds of a note on one side: all of it, or the part between two cuts.
struct NoteSide {
    double begin_s = 0.0;
    double end_s = 0.0;
    std::optional<Note> whole{};  // none: nothing sounds there, this is where it would
};

struct WarpedNote {
    NoteSide from;
    NoteSide to;
};

// In the order of both; an empty list where both are silent, none where there are too many notes.
std::optional<std::vector<WarpedNote>> warped_notes(const std::vector<Note>& from,
                                                    double from_duration_s,
                                                    const std::vector<Note>& to,
                                                    double to_duration_s);

}  // namespace tact
