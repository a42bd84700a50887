// Measured facts over a stage, where the switch is on, and where the model parts from them.
//
// Source    model/textbook
#pragma once

#include <utility>
#include <vector>

#include "app/physiology/physiology_state.h"
#include "app/stages/stage_views.h"
#include "app/ui/ui.h"
#include "viz/charts/spectrum_view.h"
#include "viz/drawing/geometry.h"

namespace tact {

// Lines at the top of `below`, as many as leave a large stage most of its room; of a pair, what
// people notice of their difference. The height that they take there.
float draw_textbook(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                    Stage stage, const Rect& below);

// Of a small stage that parts: a few words at the foot of its label, and the lines as a tooltip.
// The height that they take.
float draw_textbook_sign(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                         Stage stage, const Rect& label);

// What the spectrum draws of it; none while the switch is off.
struct MeasuredSpectrum {
    std::vector<std::pair<double, double>> felt_db;
    std::vector<MeasuredBand> bands;
};
MeasuredSpectrum measured_spectrum(const Physiology& physiology);

}  // namespace tact
