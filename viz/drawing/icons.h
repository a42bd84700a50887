// The signs of a player, those of what a pattern is, and the envelopes of its modulation.
#pragma once

#include <imgui.h>

namespace tact {

enum class Icon {
    play,
    pause,
    stop,
    to_start,
    back,
    forward,
    loop,
    locked,
    dropped,
    ring,
    tremolo
};

// Around `at`, `size` px high.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 colour);

}  // namespace tact
