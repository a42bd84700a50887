// How the wave strip looks: the wave, its lines, and what can be taken.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/wave_strip/grips.h"
#include "model/signal/waveform.h"

namespace tact {

struct StripScene {
    const Pattern& pattern;
    const StripScale& scale;
    const Waveform* waveform = nullptr;  // null: not rendered yet
    ImU32 colour = 0;
    std::optional<Grip> chosen{};
    std::optional<Grip> under{};  // the mouse
    bool hovered = false;
};

void draw_strip_picture(ImDrawList& list, const Theme& theme, const Rect& area,
                        const StripScene& scene);

}  // namespace tact
