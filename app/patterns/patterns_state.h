// How the list of patterns and the editor were left.
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
    std::uint64_t renaming_in = 0;  // number of the document
    bool rename_begun = false;      // its box has had the keyboard
};

// What an editor shows that has room for one of them.
enum class EditorTab { numbers, drawing };

struct EditorState {
    EditorTab tab = EditorTab::numbers;
    std::string active_pattern;    // the fields' keys go to it
    std::string rhythm_text;       // while being typed
    std::string rhythm_typed_for;  // name of the pattern; empty: not being typed
    RhythmChoice rhythms;
    std::optional<NoteDrag> note_drag;
};

// Taps that are being made.
struct TappingState {
    std::vector<Tap> taps;         // by the window's clock
    std::optional<double> down_s;  // since when the key or the button is held
    std::optional<double> step_s;  // by hand; none: estimated
    bool has_opened = true;        // the key that opened the dialog may still be held: no note
};

// What an empty set offers to begin with.
struct StartPage {
    std::vector<Vibration> cards;                  // read when they are first shown
    std::vector<std::filesystem::path> recent_of;  // the session's, when it was looked for ...
    std::vector<RecentFile> recent;                // ... which of them are there
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
