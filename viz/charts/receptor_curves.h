// A curve over frequency for each receptor type: solid in the type's band, dashed outside.
//
// Source    Lim & Park 2023, Figure 5 (slopes and thresholds)
// Left out  the mouse, names of the curves: draw_receptor_mark() beside them labels them.
#pragma once

#include <functional>
#include <string_view>

#include "model/common/range.h"
#include "model/physiology/mechanoreceptor.h"
#include "viz/drawing/plot.h"

namespace tact {

// For a plot with frequency along x. `value`: the curve at a frequency in Hz.
void draw_over_frequency(ImDrawList& list, const Theme& theme, const Plot& plot, Receptor receptor,
                         const std::function<double(double)>& value, ImU32 colour);

struct ReceptorCurves {
    const PerReceptor<Curve>* curves = nullptr;  // never null
    Range frequency_hz{1.0, 500.0};
    Range values{0.0, 1.0};  // at the bottom and the top
    std::string_view unit{};
};

void draw_receptor_curves(const Theme& theme, const Rect& area, const ReceptorCurves& scene);

}  // namespace tact
