#include "viz/skin/raster_cells.h"

#include <algorithm>
#include <cmath>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kTickStepPx = 16.0F;  // steps of this width show each spike
constexpr float kGapStepPx = 5.0F;    // steps of this width can be told apart
constexpr float kPale = 0.35F;        // opacity of the colour

float step_px(const Plot& plot) {
    return static_cast<float>(kStepS / (plot.x.high - plot.x.low)) * plot.area.width();
}

float left_of(const Plot& plot, std::size_t step) {
    return std::round(to_pixel(plot.x, static_cast<double>(step) * kStepS));
}

void add_rect(ImDrawList& list, float left, float top, float right, float bottom, ImU32 colour) {
    list.PrimReserve(6, 4);
    list.PrimRect({left, top}, {right, bottom}, colour);
}

// Left edges of columns on the screen, and the right edge of the last one.
std::vector<float> column_edges(const Plot& plot, const RasterWindow& window) {
    std::vector<float> edges;
    for (std::size_t c = 0; c <= window.columns; ++c) {
        edges.push_back(left_of(plot, step_of(window, c)));
    }
    return edges;
}

struct Run {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// One row of cells, each as strong as its receptors' mean count. `runs` is scratch memory.
void draw_shaded_row(const RasterInk& ink, std::span<const float> edges, std::span<const int> shade,
                     ImVec2 top_bottom, std::vector<Run>& runs) {
    const bool told_apart = step_px(ink.plot) >= kGapStepPx * ink.theme.scale;
    const float gap = told_apart ? ink.theme.hairline_px : 0.0F;
    runs.clear();
    for (std::size_t c = 0; c < shade.size();) {
        std::size_t end = c + 1;
        while (!told_apart && end < shade.size() && shade[end] == shade[c]) ++end;
        if (shade[c] > 0) runs.push_back({c, end});
        c = end;
    }
    ink.list.PrimReserve(6 * static_cast<int>(runs.size()), 4 * static_cast<int>(runs.size()));
    for (const Run& run : runs) {
        ink.list.PrimRect({edges[run.begin], top_bottom.x}, {edges[run.end] - gap, top_bottom.y},
                          ink.shades[static_cast<std::size_t>(shade[run.begin])]);
    }
}

// One row of single spikes, spread over their step as by the model.
void draw_ticked_row(const RasterInk& ink, const RasterWindow& window, std::span<const int> counts,
                     std::span<const char> pale, ImVec2 top_bottom) {
    const auto [top, bottom] = top_bottom;
    const float width = whole_px(1.25F * ink.theme.scale);
    for (std::size_t c = 0; c < window.columns; ++c) {
        const std::size_t step = window.first + c;
        const int count = counts[c];
        const ImU32 colour = pale[c] != 0 ? ink.pale : ink.full;
        if (static_cast<float>(count) * 2.0F * width > step_px(ink.plot)) {
            // Too many to tell apart.
            add_rect(ink.list, left_of(ink.plot, step), top, left_of(ink.plot, step + 1), bottom,
                     colour);
            continue;
        }
        for (const std::size_t offset : spread_spikes(count)) {
            const double time_s =
                static_cast<double>(step) * kStepS + static_cast<double>(offset) / kModelRateHz;
            const float left = std::round(to_pixel(ink.plot.x, time_s));
            add_rect(ink.list, left, top, left + width, bottom, colour);
        }
    }
}

// From the sums of a row's blocks to its drawing: counts if single spikes show, shades otherwise.
// Roots make a lone spike among many silent neighbours visible.
void to_strengths(std::span<int> sums, std::span<const int> cells, std::span<const char> pale,
                  int largest, bool ticks) {
    for (std::size_t c = 0; c < sums.size(); ++c) {
        if (sums[c] <= 0) continue;
        if (ticks) {
            sums[c] = (sums[c] + cells[c] - 1) / cells[c];
            continue;
        }
        const float share = static_cast<float>(sums[c]) / static_cast<float>(cells[c] * largest);
        sums[c] = 1 + static_cast<int>((kShades - 1) * std::sqrt(std::min(1.0F, share)));
        if (pale[c] != 0) sums[c] += kShades;
    }
}

}  // namespace

RasterInk raster_ink(ImDrawList& list, const Theme& theme, const Plot& plot, ImU32 full) {
    RasterInk ink{list, theme, plot, full, mixed(theme.pane, full, kPale)};
    for (int i = 1; i <= kShades; ++i) {
        const float share = 0.28F + 0.72F * static_cast<float>(i) / kShades;
        const auto at = static_cast<std::size_t>(i);
        ink.shades[at] = mixed(theme.pane, full, share);
        ink.shades[at + kShades] = mixed(theme.pane, full, kPale * share);
    }
    return ink;
}

RasterWindow window_of(const Plot& plot, const RasterChannel& channel) {
    RasterWindow window;
    if (channel.spike_count.empty()) return window;
    const auto steps = static_cast<double>(channel.spike_count.front().size());
    // A range that ends on a step's edge, but for rounding, does not show the next step.
    window.first =
        static_cast<std::size_t>(std::clamp(std::floor(plot.x.low / kStepS + 1e-6), 0.0, steps));
    window.last =
        static_cast<std::size_t>(std::clamp(std::ceil(plot.x.high / kStepS - 1e-6), 0.0, steps));
    if (window.last <= window.first) return {};
    window.columns = std::min(window.last - window.first,
                              static_cast<std::size_t>(std::max(1.0F, plot.area.width())));
    return window;
}

void draw_rows(const RasterInk& ink, const Rect& place, const RasterChannel& channel,
               RasterWindow window, int largest) {
    if (window.columns == 0 || window.bottom <= window.top || place.empty()) return;
    const auto finest = static_cast<std::size_t>(
        std::max(1.0F, std::floor(place.height() / (2.0F * ink.theme.scale))));
    window.rows = std::min(window.bottom - window.top, finest);
    const bool ticks = step_px(ink.plot) >= kTickStepPx * ink.theme.scale;
    std::vector<int> sums = binned(channel, window);
    const auto row_of = [&](std::size_t row) {
        return std::span{sums}.subspan(row * window.columns, window.columns);
    };
    std::vector<int> cells(window.columns);
    std::vector<char> pale(window.columns);
    for (std::size_t c = 0; c < window.columns; ++c) pale[c] = is_pale(channel, window, c) ? 1 : 0;
    for (std::size_t row = 0; row < window.rows; ++row) {
        const std::size_t receptors =
            receptor_row_of(window, row + 1) - receptor_row_of(window, row);
        for (std::size_t c = 0; c < window.columns; ++c) {
            cells[c] = static_cast<int>(receptors * (step_of(window, c + 1) - step_of(window, c)));
        }
        to_strengths(row_of(row), cells, pale, largest, ticks);
    }

    const float row_px = place.height() / static_cast<float>(window.rows);
    const float gap = row_px >= 4.0F * ink.theme.scale ? ink.theme.hairline_px : 0.0F;
    const std::vector<float> edges = column_edges(ink.plot, window);
    std::vector<Run> runs;
    for (std::size_t row = 0; row < window.rows;) {
        // Receptors at one distance fire alike: equal rows are drawn as one.
        std::size_t end = row + 1;
        while (gap == 0.0F && end < window.rows && std::ranges::equal(row_of(row), row_of(end))) {
            ++end;
        }
        const ImVec2 top_bottom{std::round(place.min.y + static_cast<float>(row) * row_px),
                                std::round(place.min.y + static_cast<float>(end) * row_px) - gap};
        ticks ? draw_ticked_row(ink, window, row_of(row), pale, top_bottom)
              : draw_shaded_row(ink, edges, row_of(row), top_bottom, runs);
        row = end;
    }
}

void draw_rate(const RasterInk& ink, const Rect& place, const RasterWindow& window,
               const RasterTotals& all) {
    if (place.empty() || window.columns == 0 || all.largest_total <= 0) return;
    const float width = whole_px(ink.theme.trace_px);
    for (std::size_t c = 0; c < window.columns; ++c) {
        const std::size_t begin = step_of(window, c);
        const std::size_t end = step_of(window, c + 1);
        double sum = 0.0;
        for (std::size_t s = begin; s < end; ++s) sum += all.per_step[s];
        if (sum <= 0.0) continue;
        const double share = sum / static_cast<double>(end - begin) / all.largest_total;
        const float top =
            std::round(place.max.y - static_cast<float>(share) * (place.height() - width));
        const float left = left_of(ink.plot, begin);
        const float right = left_of(ink.plot, end);
        add_rect(ink.list, left, top, right, place.max.y, faded(ink.full, 0.35F));
        add_rect(ink.list, left, top - width, right, top, ink.full);
    }
}

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
