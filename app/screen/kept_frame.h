// The picture of the last frame, kept on the graphics side: the next one paints only what changed.
//
// Left out  anything but OpenGL 3. All calls need the window's context to be current.
#pragma once

#include <imgui.h>

#include "viz/picture/frame_damage.h"

namespace tact {

struct KeptFrame {
    unsigned framebuffer = 0;
    unsigned texture = 0;
    FramePrint print;  // of what is in it; of no size: nothing is
};

// Paints what differs and puts the whole on the screen's back buffer, width x height pixels.
void paint(KeptFrame& kept, ImDrawData& frame, int width, int height, ImU32 background);

// The next frame is painted again: what pictures are made of has changed.
void forget(KeptFrame& kept);

void destroy(KeptFrame& kept);

}  // namespace tact
