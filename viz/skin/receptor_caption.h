// The words, the colour scale and the scale bar of a map of receptors. Private to the receptor
// view and its legend.
#pragma once

#include <string>

#include "viz/skin/receptor_view.h"

namespace tact {

// Height of one line of the caption.
float caption_line_px(const Theme& theme);

// Opaque colour of a value of 0..1: what lies behind a mark must not change it.
ImU32 value_colour(const Theme& theme, Receptor receptor, double value);

// From 0 to 1, left to right.
void draw_ramp(ImDrawList& list, const Theme& theme, const Rect& bar, Receptor receptor);

// Of one that fires, and of one beyond the finger's edge.
ImU32 firing_colour(const Theme& theme, Receptor receptor);
ImU32 beyond_colour(const Theme& theme);

// What a caption says of a type that fires, or why none does: as much as fits, nothing at last, and
// what can be counted in the raster before what Eq. 2 gives.
std::string receptor_state_text(const ReceptorScene& scene, const ImFont* font, float room_px);

// Name and number of receptors; what they fire and the radius or why there are none; if it fits,
// what the colours stand for.
void draw_caption(ImDrawList& list, const Theme& theme, const Rect& caption,
                  const ReceptorScene& scene);

// The same, flush left in the middle of what is right of a map, and the scale bar below it; as many
// lines as fit.
void draw_caption_beside(ImDrawList& list, const Theme& theme, const Rect& caption,
                         const ReceptorScene& scene, float px_per_mm);

// What words beside a map need at least.
float least_caption_px(const Theme& theme);

// A bar of a round number of mm right of the map's foot, as far as `right_px`; none where it does
// not fit.
void draw_scale_bar(ImDrawList& list, const Theme& theme, const Rect& map, float right_px,
                    float px_per_mm);

}  // namespace tact
