// One channel of a raster as cells or single spikes, and its population rate. Private to the raster
// view.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "model/common/units.h"
#include "model/physiology/spike_train.h"
#include "viz/skin/raster_view.h"

namespace tact {

// Spike counts squeezed into fewer rows and columns. Private to the raster view.
//
// Input     counts by receptor and 5 ms step
// Output    sums over blocks of neighbouring rows and steps: nothing is lost, nothing counted twice

// Steps [first, last) shared out to columns, receptors [top, bottom) in drawing order to rows.
struct RasterWindow {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t columns = 0;  // at most last - first
    std::size_t top = 0;
    std::size_t bottom = 0;
    std::size_t rows = 0;  // at most bottom - top
};

// First step and first receptor of a column and of a row; one beyond the last gives the ends.
std::size_t step_of(const RasterWindow& window, std::size_t column);
std::size_t receptor_row_of(const RasterWindow& window, std::size_t row);

// rows x columns sums, row by row.
std::vector<int> binned(const RasterChannel& channel, const RasterWindow& window);

// Whether the column has only pale steps.
bool is_pale(const RasterChannel& channel, const RasterWindow& window, std::size_t column);

// Totals over all receptors.
struct RasterTotals {
    std::vector<int> per_step;
    int largest_count = 0;  // of one receptor in one step
    int largest_total = 0;  // of all receptors in one step
};

RasterTotals totals(const RasterChannel& channel);

bool any_spike(const RasterChannel& channel);

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
