// Where in time the views look: one playhead.
//
// Left out  sound: while a device plays, its own clock moves the playhead.
#pragma once

#include "viz/drawing/time_range.h"

namespace tact {

// Seconds from the start of the pattern.
struct Playhead {
    double at_s = 0.0;
    double speed = 0.1;  // of real time: 1, 1/10, 1/100
    bool playing = false;
    bool loop = true;
};

// `elapsed_s` of real time later. At the end it starts over, or stays there and stops.
Playhead advanced(Playhead playhead, double elapsed_s, double duration_s);

// To the start of the step that lies `steps` from the playhead's own, which stops.
Playhead stepped(Playhead playhead, int steps, double duration_s);

}  // namespace tact
