// The words, the colour scale and the scale bar of a map of receptors. Private to the receptor view
// and its legend.
#pragma once

#include <string>

#include "viz/drawing/theme.h"
#include "viz/skin/receptor_view.h"

namespace tact {

// Height of one line of the caption.
float caption_line_px(const Theme& theme);

// Opaque colour of a value of 0..1: the background of a mark must not change it.
ImU32 value_colour(const Theme& theme, Receptor receptor, double value);

// Colours from 0 to 1, left to right.
void draw_ramp(ImDrawList& list, const Theme& theme, const Rect& bar, Receptor receptor);

// Colours of a firing receptor, and of one beyond the finger's edge.
ImU32 firing_colour(const Theme& theme, Receptor receptor);
ImU32 beyond_colour(const Theme& theme);

// Text on a type that fires, or the reason why none does: as much as fits, perhaps nothing. Numbers
// that can be counted in the raster come before those of Eq. 2.
std::string receptor_state_text(const ReceptorScene& scene, const ImFont* font, float room_px);

// Name and number of receptors; their spikes and radius, or the reason why no receptor fires; if it
// fits, the meaning of the colours.
void draw_caption(ImDrawList& list, const Theme& theme, const Rect& caption,
                  const ReceptorScene& scene);

// The same for a caption right of a map, flush left and vertically centred, with the scale bar
// below; as many lines as fit.
void draw_caption_beside(ImDrawList& list, const Theme& theme, const Rect& caption,
                         const ReceptorScene& scene, float px_per_mm);

// The least width of words beside a map.
float least_caption_px(const Theme& theme);

// A bar of a round number of mm, right of the map's bottom edge and up to `right_px`; left out if
// it does not fit.
void draw_scale_bar(ImDrawList& list, const Theme& theme, const Rect& map, float right_px,
                    float px_per_mm);

// The meaning of colours, halos and rings in maps of receptors, in one line for all maps.

// The colour scale of all four types, from 0 to the rate of the strongest colour, and as much of
// the rest as fits.
void draw_receptor_legend(ImDrawList& list, const Theme& theme, const Rect& line,
                          double largest_hz);

}  // namespace tact
