// Spikes of all receptors over time: one row each, grouped by type, nearest to the probe on top.
// Beneath each type its population rate.
//
// Input     spike counts per 5 ms step; the visible range of time
// Output    the receptor and the time under the mouse, the clicked receptor, the dragged playhead
// Valid     any number of receptors and steps. If rows or steps are finer than pixels, a cell shows
//           their mean count, stronger for more; the work is one pass over the counts.
// Left out  zooming (the caller's range), the text of the read-out (the caller draws it).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/physiology/mechanoreceptor.h"
#include "viz/drawing/plot.h"

namespace tact {

struct RasterChannel {
    Receptor receptor = Receptor::meissner;
    std::span<const std::vector<int>> spike_count{};  // receptor (as in the grid), 5 ms step
    std::span<const std::size_t> order{};  // receptors from the top row down; empty: in the order
                                           // of the grid
    bool pale = false;                     // its spikes only follow the filter's leak
    std::span<const char> pale_steps{};    // steps without vibration; empty: none
    std::string note{};                    // below the name, if there is room
};

struct RasterSpot {
    std::size_t channel = 0;   // index in the scene
    std::size_t receptor = 0;  // index in the grid

    bool operator==(const RasterSpot&) const = default;
};

struct RasterScene {
    std::span<const RasterChannel> channels{};  // from the top; empty: not computed yet
    double start_s = 0.0;
    double end_s = 1.0;
    // Width left of the time axis, so that panes align; nullopt: as the names need; 0: no names.
    std::optional<float> names_px{};
    bool time_axis = true;  // with ticks; false for all but the lowest of several
    bool rates = true;
    std::optional<RasterSpot> selected{};
    std::optional<RasterSpot> pointed{};  // under the mouse elsewhere
    std::optional<double> playhead_s{};
    std::optional<double> crosshair_s{};  // time under the mouse in another plot
    bool stale = false;
};

struct RasterAction {
    std::optional<RasterSpot> hovered{};
    std::optional<double> hovered_s{};
    std::optional<RasterSpot> clicked{};  // when released over the pressed row
    std::optional<double> scrubbed_s{};   // the mouse is held down: the playhead's new place
};

RasterAction draw_raster(const char* id, const Theme& theme, const Rect& area,
                         const RasterScene& scene);

// Places of one channel's parts.
struct RasterBand {
    Rect rows{};          // all its receptors; for a channel without spikes, a line of text
    Rect rate{};          // empty if there is no room
    float row_px = 0.0F;  // height of one receptor, less than a pixel if there are many
    bool fires = false;   // it has spikes
};

// Pure, for tests.
struct RasterLayout {
    Plot plot;  // all bands; its x axis is time
    std::vector<RasterBand> bands;
};

RasterLayout raster_layout(const Theme& theme, const Rect& area, const RasterScene& scene);

// The receptor whose row is at a place on the screen.
std::optional<RasterSpot> spot_at(const RasterLayout& layout, const RasterScene& scene, ImVec2 at);

}  // namespace tact
