// What the wave strip remembers between frames.
#pragma once

#include <optional>
#include <string>

#include "app/wave_strip/grips.h"

namespace tact {

// From the press of the mouse until it is let go.
struct GripHold {
    Grip grip;
    Pattern before;
    StripScale scale;  // stays as it was, or what is dragged would run away from the mouse
    ImVec2 pressed;
    bool moved = false;
    const char* verb = "Change";  // of the step that it becomes
};

inline constexpr Range kStripHeight{120.0, 900.0};  // px at a scale of 1

// The name of the chosen one's own number, which arrows nudge.
inline constexpr const char* kChosenValue = "chosen_value";

struct StripState {
    std::string pattern;            // its name; all below is of it, but for height and tool
    std::optional<TimeRange> view;  // none: the whole
    std::optional<GripHold> held;
    std::optional<Grip> chosen;     // a point or a transient, whose numbers are shown
    bool has_just_drawn = false;    // the last press put something where nothing was
    bool is_scrolled_past = false;  // by the wheel, with the pane that it is in
    float height = 150.0F;          // of kStripHeight
    StripTool tool = StripTool::curves;
};

}  // namespace tact
