// Measured facts over a stage, if they are switched on, and the model's deviations from them.
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

// Lines at the top of `below`, limited so that a large stage keeps most of its room; for a pair,
// the difference that people notice. Returns the height used there.
float draw_textbook(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                    Stage stage, const Rect& below);

// A small stage with a deviation: a few words at the bottom of its label, and the lines as a
// tooltip. Returns the height used.
float draw_textbook_sign(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                         Stage stage, const Rect& label);

// The part for the spectrum; null while the switch is off.
struct MeasuredSpectrum {
    std::vector<std::pair<double, double>> felt_db;
    std::vector<MeasuredBand> bands;
};
MeasuredSpectrum measured_spectrum(const Physiology& physiology);

}  // namespace tact
