// One channel of a raster as cells or single spikes, and its population rate. Private to the raster
// view.
#pragma once

#include <array>

#include "model/common/units.h"
#include "model/physiology/spike_train.h"
#include "viz/skin/raster_bins.h"

namespace tact {

inline constexpr int kShades = 16;

// The canvas, its plot, and colours.
struct RasterInk {
    ImDrawList& list;
    const Theme& theme;
    const Plot& plot;
    ImU32 full;  // colour of the most spikes
    ImU32 pale;  // the same, in pale steps
    // By strength, 0: none; then the pale ones.
    std::array<ImU32, 2 * kShades + 1> shades{};
};

RasterInk raster_ink(ImDrawList& list, const Theme& theme, const Plot& plot, ImU32 full);

// The visible steps of a channel; without columns if no step is visible.
RasterWindow window_of(const Plot& plot, const RasterChannel& channel);

// The window's receptors within `place`: cells as strong as their mean count, strongest at
// `largest` spikes a step; if steps are wide enough, single spikes, spread as by the model.
void draw_rows(const RasterInk& ink, const Rect& place, const RasterChannel& channel,
               RasterWindow window, int largest);

// Impulses per second of all receptors of the type, up to the largest of the whole signal.
void draw_rate(const RasterInk& ink, const Rect& place, const RasterWindow& window,
               const RasterTotals& all);

}  // namespace tact
