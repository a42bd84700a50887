// Pieces of a drawn frame, in the order in which they were drawn, joined to shapes: touching quads
// to lines and level rectangles, glyphs to texts with their halos, polygons of one colour to one
// shape.
//
// Source    the pieces that ImGui 1.86 makes of lines and rectangles without anti-aliasing
// Output    shapes cut by the clip rectangle of when they were added
#pragma once

#include <imgui.h>

#include <array>
#include <optional>
#include <vector>

#include "viz/drawing/geometry.h"
#include "viz/picture/frame_shapes.h"
#include "viz/picture/frame_text.h"

namespace tact {

// Outlines of flat triangle meshes.
//
// Valid     meshes whose triangles all turn the same way, as ImGui's do

using Outline = std::vector<ImVec2>;

// The directed edges of the triangles (three indices into the vertices each) that no neighbour runs
// back along, joined. Holes and islands are outlines of their own; successive corners in one place
// are one.
std::vector<Outline> outlines_of(const std::vector<ImDrawIdx>& triangles, const ImDrawVert* v);

// Clockwise on the screen.
void make_clockwise(Outline& outline);

using Quad = std::array<ImVec2, 4>;

// A quad as a piece of a line.
struct Segment {
    ImVec2 from;
    ImVec2 to;
    float width_px = 0;
    bool upright = false;  // also a rectangle as ImGui writes them
    Quad corners{};
};

// What has been joined so far, and what may still continue.
struct ShapeJoining {
    Rect clip{};
    std::vector<Shape> shapes{};
    std::vector<Segment> chain{};
    ImU32 chain_colour = 0;
    std::optional<TextRun> run{};
    ImU32 run_colour = 0;
};

// Adds to shapes as long as they continue; call end_all() before the clip rectangle changes.
void add_quad(ShapeJoining& joining, const Quad& quad, ImU32 colour);
void add_glyph(ShapeJoining& joining, const DrawnGlyph& glyph, ImU32 colour);
void end_all(ShapeJoining& joining);

// These end nothing by themselves.
void add_polygon(ShapeJoining& joining, Outline outline, ImU32 colour);
void add_circle(ShapeJoining& joining, const Circle& circle, ImU32 colour);

// The clip rectangle if it cuts something off; nothing is left where `box` is outside.
struct Clipping {
    bool nothing_left = false;
    std::optional<Rect> clip{};
};

Clipping clipping(const Rect& clip, const Rect& box);
Rect bounds_of(const Outline& points, float margin_px);

}  // namespace tact
