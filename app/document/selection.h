// The part of the document that the person is looking at.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// A number of the pattern in the editor whose slider the mouse rests on: what the pattern would be
// over the slider's range, and the number there in words.
struct RestedNumber {
    std::string name;   // of the pattern
    std::string field;  // its id
    std::vector<Pattern> patterns;
    std::vector<std::string> words;

    bool operator==(const RestedNumber&) const = default;
};

// A change of a pattern that is pointed at, such as one that would separate two.
struct SuggestedChange {
    std::string name;  // of the pattern
    Pattern changed;
    std::string words;

    bool operator==(const SuggestedChange&) const = default;
};

// The part of the document that the person is looking at. Indices into document.set.vibrations.
struct Selection {
    std::string pinned;       // name of the pattern shown for comparison; empty: none
    std::string partner;      // name of the pattern that makes a pair with the current one
    std::size_t current = 0;  // shown in the editor and the middle column
    std::size_t layer = 0;    // that is open in the editor, of the pattern of the name below
    std::string layer_of;
    std::set<std::size_t> others;             // edited together with it
    std::optional<std::size_t> hovered;       // in this frame, by any panel drawn so far
    std::string search;                       // what the list is narrowed to
    bool scroll_to_current = false;           // in the list, in the next frame
    std::set<std::string> too_close{};        // names in pairs that are marked as too close
    std::set<std::string> picked{};           // names of the subset that is picked
    bool is_pick_preview = false;             // by a preview of the map, or an earlier one
    bool only_picked = false;                 // the list is narrowed to them, where there are any
    std::vector<std::size_t> table_order{};   // as a table shows them; empty: no table
    std::set<std::string> unfelt{};           // names of those that no receptor answers to
    std::optional<std::size_t> hovered_last;  // in the last frame, by any panel
    // Two at once, as a cell of the matrix has them: in this frame, and in the last.
    std::optional<std::pair<std::size_t, std::size_t>> hovered_pair{};
    std::optional<std::pair<std::size_t, std::size_t>> hovered_pair_last{};
    // In this frame, by any panel; a candidate is in no document yet.
    std::optional<Vibration> pressed{};
    std::optional<RestedNumber> rested{};        // in this frame
    std::optional<SuggestedChange> suggested{};  // in this frame
    bool on_track = false;                       // in this frame the mouse is on the rested one's
};

inline bool is_narrowed_to_picked(const Selection& selection) {
    return selection.only_picked && !selection.picked.empty();
}

}  // namespace tact
