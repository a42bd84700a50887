#include "viz/skin/raster_bins.h"

#include <algorithm>

namespace tact {
namespace {

const std::vector<int>& counts_of(const RasterChannel& channel, std::size_t row) {
    return channel.spike_count[channel.order.empty() ? row : channel.order[row]];
}

}  // namespace

std::size_t step_of(const RasterWindow& window, std::size_t column) {
    return window.first + column * (window.last - window.first) / window.columns;
}

std::size_t receptor_row_of(const RasterWindow& window, std::size_t row) {
    return window.top + row * (window.bottom - window.top) / window.rows;
}

std::vector<int> binned(const RasterChannel& channel, const RasterWindow& window) {
    std::vector<int> sums(window.rows * window.columns, 0);
    const bool one_each = window.columns == window.last - window.first;
    std::vector<std::size_t> begins(window.columns + 1);
    for (std::size_t c = 0; c < begins.size() && window.columns > 0; ++c) {
        begins[c] = step_of(window, c);
    }
    for (std::size_t row = 0; row < window.rows; ++row) {
        int* out = sums.data() + row * window.columns;
        const std::size_t end = receptor_row_of(window, row + 1);
        for (std::size_t r = receptor_row_of(window, row); r < end; ++r) {
            const int* counts = counts_of(channel, r).data();
            if (one_each) {
                for (std::size_t c = 0; c < window.columns; ++c) out[c] += counts[window.first + c];
                continue;
            }
            for (std::size_t c = 0; c < window.columns; ++c) {
                for (std::size_t s = begins[c]; s < begins[c + 1]; ++s) out[c] += counts[s];
            }
        }
    }
    return sums;
}

bool is_pale(const RasterChannel& channel, const RasterWindow& window, std::size_t column) {
    const std::size_t end = step_of(window, column + 1);
    for (std::size_t step = step_of(window, column); step < end; ++step) {
        if (step >= channel.pale_steps.size() || channel.pale_steps[step] == 0) return false;
    }
    return true;
}

RasterTotals totals(const RasterChannel& channel) {
    RasterTotals result;
    if (channel.spike_count.empty()) return result;
    const std::size_t steps = channel.spike_count.front().size();
    result.per_step.assign(steps, 0);
    for (const std::vector<int>& counts : channel.spike_count) {
        for (std::size_t s = 0; s < steps; ++s) {
            result.per_step[s] += counts[s];
            result.largest_count = std::max(result.largest_count, counts[s]);
        }
    }
    for (const int total : result.per_step) {
        result.largest_total = std::max(result.largest_total, total);
    }
    return result;
}

bool any_spike(const RasterChannel& channel) {
    return std::ranges::any_of(channel.spike_count, [](const std::vector<int>& counts) {
        return std::ranges::any_of(counts, [](int count) { return count > 0; });
    });
}

}  // namespace tact
