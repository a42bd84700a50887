// Two signals on one scale: what was measured or heard, and the pattern beside it.
#pragma once

#include <string>

#include "app/ui/ui.h"
#include "model/signal/waveform.h"

namespace tact {

struct Overlay {
    const char* rect;  // its name for tests
    const Waveform& filled;
    const char* filled_name;
    const Waveform& dashed;  // of this one, how far it reaches up and down
    const char* dashed_name;
};

void draw_overlay(Ui& ui, const Overlay& overlay);

// The same room while there is nothing to draw.
void draw_empty_overlay(const Ui& ui, const char* title, const std::string& reason);

}  // namespace tact
