// State of the wave strip between frames.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/wave_strip/grips.h"
#include "model/algebra/chosen_notes.h"
#include "model/signal/waveform.h"

namespace tact {

// A drag, from the press of the mouse to its release.
struct GripHold {
    Grip grip;
    Pattern before;
    StripScale scale;  // does not change during a drag, so that the grip stays at the mouse
    ImVec2 pressed;
    bool moved = false;
    const char* verb = "Change";  // in the label of the step of undo
    ChosenNotes notes{};          // chosen together with the held one
};

// A box that chooses the notes inside it, in px, until the mouse is released.
struct NoteBox {
    float from_px = 0.0F;
    float to_px = 0.0F;
    StripScale scale;
};

// The sum of the other layers, starting where the open one begins.
struct LayersBeneath {
    std::uint64_t revision = 0;  // the document's revision
    Waveform waveform;
};

inline constexpr Range kStripHeight{120.0, 900.0};  // px at scale 1

// The name of the chosen item's own number, which arrows nudge.
inline constexpr const char* kChosenValue = "chosen_value";

struct StripState {
    std::string pattern;  // name of the pattern, and its layer's; everything below but height and
                          // tool belongs to it
    std::optional<GripHold> held;
    std::optional<Grip> chosen;  // a point or a transient, whose numbers are shown
    ChosenNotes notes;           // with the tool of notes
    std::optional<NoteBox> box;
    std::optional<LayersBeneath> beneath;
    std::optional<double> pointed_s;  // time under the mouse, where notes are pasted
    bool is_scrubbed = false;         // the playhead is dragged on the ruler
    bool has_just_drawn = false;      // the last press added an item at an empty place
    bool is_scrolled_past = false;    // the wheel scrolls the pane, with the strip in it
    float height = 150.0F;            // within kStripHeight
    StripTool tool = StripTool::curves;
};

}  // namespace tact
