// How the list of patterns and the editor were left.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/patterns/rhythm_choice.h"

namespace tact {

// A click in the list takes effect at the end of its frame: what it ends in the editor, such as a
// number being typed, still belongs to the pattern selected before.
struct RowClick {
    std::size_t index = 0;
    bool shift = false;
    bool ctrl = false;
};

struct SetPanelState {
    std::optional<RowClick> clicked;
    std::string rename_text;
    std::optional<std::size_t> renaming;
};

struct EditorState {
    std::string active_field;   // arrows nudge it
    double typed_number = 0.0;  // in the entry of active_field; taken when the entry is left
    bool typing_number = false;
    std::string rhythm_text;       // while being typed
    std::string rhythm_typed_for;  // name of the pattern; empty: not being typed
    RhythmChoice rhythms;
    std::optional<NoteDrag> note_drag;
};

}  // namespace tact
