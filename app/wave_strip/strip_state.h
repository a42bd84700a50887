// What the wave strip remembers between frames.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/wave_strip/grips.h"
#include "model/algebra/chosen_notes.h"
#include "model/signal/waveform.h"

namespace tact {

// From the press of the mouse until it is let go.
struct GripHold {
    Grip grip;
    Pattern before;
    StripScale scale;  // stays as it was, or what is dragged would run away from the mouse
    ImVec2 pressed;
    bool moved = false;
    const char* verb = "Change";  // of the step that it becomes
    ChosenNotes notes{};          // chosen with the one that is held
};

// Notes are chosen by what it spans, px, until the mouse is let go.
struct NoteBox {
    float from_px = 0.0F;
    float to_px = 0.0F;
    StripScale scale;
};

// What the other layers sum up to, from where the open one begins.
struct LayersBeneath {
    std::uint64_t revision = 0;  // of the document
    Waveform waveform;
};

inline constexpr Range kStripHeight{120.0, 900.0};  // px at a scale of 1

// The name of the chosen one's own number, which arrows nudge.
inline constexpr const char* kChosenValue = "chosen_value";

struct StripState {
    std::string pattern;  // its name, and its layer's; all below is of it, but for height and tool
    std::optional<GripHold> held;
    std::optional<Grip> chosen;  // a point or a transient, whose numbers are shown
    ChosenNotes notes;           // with the tool of notes
    std::optional<NoteBox> box;
    std::optional<LayersBeneath> beneath;
    std::optional<double> pointed_s;  // by the mouse over it: where notes are pasted
    bool is_scrubbed = false;         // the playhead is held, on the ruler
    bool has_just_drawn = false;      // the last press put something where nothing was
    bool is_scrolled_past = false;    // by the wheel, with the pane that it is in
    float height = 150.0F;            // of kStripHeight
    StripTool tool = StripTool::curves;
};

}  // namespace tact
