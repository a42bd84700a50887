// The picture of the wave strip: the wave, its lines, and grips.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "app/wave_strip/strip_state.h"
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
    ChosenNotes notes{};
    std::optional<NoteBox> box{};
    std::optional<double> playhead_s{};
    const Waveform* ghost = nullptr;  // below everything else, dim, with its name
    std::string ghost_words{};
    bool is_ruler_hovered = false;
};

void draw_strip_picture(ImDrawList& list, const Theme& theme, const Rect& area,
                        const StripScene& scene);

}  // namespace tact
