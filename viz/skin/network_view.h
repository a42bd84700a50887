// The relay network of one channel in one 5 ms step: its layers side by side, activity as colour on
// a root scale.
//
// Source    Lim & Park 2023, section 4.3; a cell moves one place per layer, so only a shrinking
//           diamond of cells (outlined) can still reach the centre.
// Input     the spikes and every layer after them, whole; the cap of a cell
// Output    the cell under the mouse and the clicked cell
// Valid     any number of layers of any width; all are drawn with one cell size, in rows if needed
// Left out  kernels, change from step to step, the text of the read-out (the caller draws it).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/physiology/relay_network.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

struct NetworkCell {
    std::size_t layer = 0;
    int column = 0;  // from the centre
    int row = 0;

    bool operator==(const NetworkCell&) const = default;
};

struct NetworkScene {
    std::span<const RelayLayer> layers{};  // the spikes first; empty: not computed yet
    std::span<const std::string> names{};  // one per layer
    double cap = 50.0;                     // the value with the brightest colour; cells that have
                                           // it are marked
    std::optional<NetworkCell> pointed{};  // under the mouse elsewhere
    bool legend = true;                    // beneath the maps; false: the caller draws it elsewhere
    bool stale = false;
};

struct NetworkAction {
    std::optional<NetworkCell> hovered{};
    std::optional<NetworkCell> clicked{};
};

NetworkAction draw_network(const char* id, const Theme& theme, const Rect& area,
                           const NetworkScene& scene);

// No spikes arrive, so all layers are silent.
bool is_silent(const NetworkScene& scene);

// The meaning of the colours and the outline, in one line, as far as it fits.
void draw_network_legend(ImDrawList& list, const Theme& theme, const Rect& line, double cap);

// Places of the parts. Pure, for tests.
struct NetworkLayout {
    std::vector<Rect> maps;      // the cells of each layer, its own width
    std::vector<Rect> captions;  // beneath or right of each map; empty if there is no room
    bool beside = false;         // captions are right of the maps
    float between_px = 0.0F;     // then the gap from a caption to the next map's place
    Rect legend;                 // one line at the bottom; empty if there is no room
    float cell_px = 0.0F;        // the same in all maps
};

NetworkLayout network_layout(const Theme& theme, const Rect& area, const NetworkScene& scene);

std::optional<NetworkCell> cell_at(const NetworkLayout& layout, const NetworkScene& scene,
                                   ImVec2 at);

// Whether the cell's activity can still reach the centre of the last layer.
bool reaches_centre(const NetworkScene& scene, const NetworkCell& cell);

}  // namespace tact
