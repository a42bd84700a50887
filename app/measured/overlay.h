// Two signals on one scale: the measured or heard signal, and its pattern.
#pragma once

#include <string>

#include "app/ui/ui.h"
#include "model/signal/waveform.h"

namespace tact {

struct Overlay {
    const char* rect;  // name for tests
    const Waveform& filled;
    const char* filled_name;
    const Waveform& dashed;  // draws only the envelope of this one
    const char* dashed_name;
};

void draw_overlay(Ui& ui, const Overlay& overlay);

// Reserves the same room while there is nothing to draw.
void draw_empty_overlay(const Ui& ui, const char* title, const std::string& reason);

}  // namespace tact
