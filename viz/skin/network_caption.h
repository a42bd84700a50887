// The colours, words and legend of the relay network's maps. Private to the network view.
#pragma once

#include "viz/skin/network_view.h"

namespace tact {

// Colour of a cell: viridis over the root of its share of the cap, so that a single spike shows
// beside a saturated layer.
ImU32 activity_colour(double spikes, double cap);

// A layer's name, and what its centre holds.
void draw_layer_caption(ImDrawList& list, const Theme& theme, const Rect& caption,
                        const NetworkScene& scene, std::size_t k);

// What colours and the outline mean, as far as it fits; or that there are no spikes.
void draw_network_legend(ImDrawList& list, const Theme& theme, const Rect& line,
                         const NetworkScene& scene);

}  // namespace tact
