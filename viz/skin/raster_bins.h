// Spike counts squeezed into fewer rows and columns. Private to the raster view.
//
// Input     counts by receptor and 5 ms step
// Output    sums over blocks of neighbouring rows and steps: nothing is lost, nothing counted twice
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "viz/skin/raster_view.h"

namespace tact {

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

}  // namespace tact
