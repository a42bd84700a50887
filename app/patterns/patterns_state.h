// State of the list of patterns and of the editor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/layers/layers_bar.h"
#include "app/patterns/recording_state.h"
#include "app/patterns/rhythm_choice.h"
#include "app/session/session.h"
#include "app/wave_strip/strip_state.h"
#include "model/pattern/tapped_rhythm.h"
#include "model/set/pattern_set.h"

namespace tact {

// A click in the list takes effect at the end of its frame: an edit that it ends, such as a number
// being typed, belongs to the pattern selected before.
struct RowClick {
    std::size_t index = 0;
    bool shift = false;
    bool ctrl = false;
};

struct SetPanelState {
    std::optional<RowClick> clicked;
    std::string rename_text;
    std::optional<std::size_t> renaming;
    std::uint64_t renaming_in = 0;  // number of the document
    bool rename_begun = false;      // its field has had the keyboard
};

// The part that an editor shows if it has room for only one.
enum class EditorTab { numbers, drawing };

struct EditorState {
    EditorTab tab = EditorTab::numbers;
    std::string active_pattern;    // keys of the fields go to it
    std::string rhythm_text;       // while typing
    std::string rhythm_typed_for;  // name of the pattern; empty: no row is being renamed
    RhythmChoice rhythms;
    std::optional<NoteDrag> note_drag;
};

// A rhythm being tapped.
struct TappingState {
    std::vector<Tap> taps;         // on the window's clock
    std::optional<double> down_s;  // time at which the key or button was pressed
    std::optional<double> step_s;  // set by hand; nullopt: estimated
    bool has_opened = true;        // the key that opened the dialog may still be held, and starts
                                   // no note
};

// Ways to begin, offered while the set is empty.
struct StartPage {
    std::vector<Vibration> cards;                  // read when first shown
    std::vector<std::filesystem::path> recent_of;  // the session's list when it was looked for ...
    std::vector<RecentFile> recent;                // ... and the files of it that exist
};

struct PatternPanes {
    StartPage start;
    SetPanelState list;
    StripState strip;
    EditorState editor;
    LayersBar layers;
    TappingState tapping;
    RecordingEditor recording;
};

}  // namespace tact
