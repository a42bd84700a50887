// A fingertip from above or tilted, to scale in mm: the ground on which receptors are drawn.
//
// Source    ours: the pad of an adult's finger is about 16 x 20 mm.
// Left out  perspective (equal lengths stay equal, so that maps can be compared), ridges.
#pragma once

#include <imgui.h>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

inline constexpr double kFingertipWidthMm = 16.0;
inline constexpr double kFingertipLengthMm = 20.0;

// From places on the skin to pixels.
struct SkinView {
    ImVec2 probe_px{0, 0};     // the centre
    float px_per_mm = 1.0F;    // scale along the skin, across the view
    float height_px = 0.0F;    // height of a value of 1 above the skin; 0 seen from above
    float yaw_rad = 0.0F;      // rotation of the skin
    float foreshorten = 1.0F;  // shortening of lengths away from the eye; 1 seen from above
};

// The skin within half_extent_mm of the probe in a square; tilted 0 (from above) to 1.
SkinView skin_view(const Rect& square, double half_extent_mm, float tilted);

// A place relative to the probe, raised by a value of 0..1.
ImVec2 to_pixel(const SkinView& view, double x_mm, double y_mm, double raised = 0.0);

// Whether a place, relative to the probe, is within the outline that draw_fingertip() draws.
bool is_on_fingertip(double x_mm, double y_mm);

ImU32 skin_colour(const Theme& theme);

// A round shape with a soft edge; the tip points up.
void draw_fingertip(ImDrawList& list, const Theme& theme, const SkinView& view);

// A circle around the probe.
void draw_skin_circle(ImDrawList& list, const SkinView& view, double radius_mm, double raised,
                      ImU32 colour, float width_px);

}  // namespace tact
