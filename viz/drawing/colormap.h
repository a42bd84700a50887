// Colours for numbers: readable by colour-blind people and in grey, never rainbow.
//
// Source    viridis: van der Walt & Smith 2015; cividis: Nunez, Anderton & Renslow 2018;
//           the diverging map is ours: Okabe-Ito blue and vermillion with white between.
// Left out  the original 256-entry tables: these interpolate a few of their entries, within 4/255.
#pragma once

#include <imgui.h>

namespace tact {

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
