// The colours, words and legend of the relay network's maps. Private to the network view.
#pragma once

#include "viz/skin/network_view.h"

namespace tact {

// Colour of a cell: viridis over the root of its share of the cap, so that a single spike is
// visible beside a saturated layer.
ImU32 activity_colour(double spikes, double cap);

// The size that every caption needs, whatever the values at the centres.
float caption_width_px(const Theme& theme, const NetworkScene& scene);

// A layer's name, and the value at its centre: centred beneath a map, or flush left beside it.
void draw_layer_caption(ImDrawList& list, const Theme& theme, const Rect& caption, bool beside,
                        const NetworkScene& scene, std::size_t k);

}  // namespace tact
