// Colours as ImGui packs them (ImU32), and arithmetic on them.
//
// Source    contrast: WCAG 2.1, relative luminance of sRGB.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tact {

// An opaque colour from 0xRRGGBB.
constexpr ImU32 rgb(std::uint32_t hex) {
    return 0xFF000000U | ((hex & 0xFFU) << 16U) | (hex & 0xFF00U) | ((hex >> 16U) & 0xFFU);
}

// "#RRGGBB"; nothing for any other text.
std::optional<ImU32> parse_colour(std::string_view text);

// "#rrggbb", without the opacity.
std::string hex_text(ImU32 colour);

// The colour with its opacity multiplied, 0..1.
ImU32 faded(ImU32 colour, float opacity);

// From a (t = 0) to b (t = 1), all four components.
ImU32 mixed(ImU32 a, ImU32 b, float t);

// 0 (black) to 1 (white); opacity is ignored.
double luminance(ImU32 colour);

// 1 to 21; text wants 4.5, graphics 3.
double contrast(ImU32 a, ImU32 b);

// Black or white, whichever reads better on `ground`.
ImU32 readable_on(ImU32 ground);

// Colours for numbers: readable by colour-blind people and in grey, never rainbow.
//
// Source    viridis: van der Walt & Smith 2015; cividis: Nunez, Anderton & Renslow 2018;
//           the diverging map is ours: Okabe-Ito blue and vermillion with white between.
// Left out  the original 256-entry tables: these interpolate a few of their entries, within 4/255.

// t in 0..1 is clamped, NaN is taken as 0; 256 steps.
ImU32 viridis(double t);
ImU32 cividis(double t);

// How far apart a pair is, as a share of the most: bright where alike, which is what a designer
// looks for. Cividis, from its bright end.
ImU32 closeness_colour(double share);

// The part of viridis that stands out from a ground, 3:1 at least: marks are seen on it, the lowest
// on a dark one and the highest on a light one too.
struct MarkColours {
    double from = 0.0;
    double to = 1.0;

    ImU32 operator()(double t) const;  // t in 0..1
};
MarkColours mark_colours(ImU32 ground);

// t in -1..1: blue below zero, white at zero, orange above.
ImU32 diverging(double t);

}  // namespace tact
