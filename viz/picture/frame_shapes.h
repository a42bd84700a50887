// What the triangles of a drawn frame stand for: rectangles, lines, polygons, discs and text.
//
// Source    the triangles that ImGui 1.86 makes of each kind without anti-aliasing.
// Input     a frame drawn with the style's anti-aliasing off, so that the geometry is exact
// Output    shapes from back to front, those outside their clip rectangle left out
// Left out  textures but the fonts', draw callbacks, holes in meshes (ImGui makes none). Corners of
//           several colours that make no linear gradient get their mean.
// Exact     outlines are the triangles' own. Where opaque shapes of one colour follow each other
//           they become one; the halo around a text becomes part of it.
#pragma once

#include <imgui.h>

#include <optional>
#include <variant>
#include <vector>

#include "viz/drawing/fonts.h"
#include "viz/drawing/geometry.h"
#include "viz/picture/frame_text.h"

namespace tact {

struct Polygons {
    std::vector<std::vector<ImVec2>> outlines{};  // clockwise on the screen
};

struct Polyline {
    std::vector<ImVec2> points{};
    bool closed = false;
};

struct Polylines {
    std::vector<Polyline> lines{};
    float width_px = 0;
};

struct Circle {
    ImVec2 centre;
    float radius_px = 0;
};

// From the shape's colour at `from` to `to_colour` at `to`, constant across.
struct GradientPolygon {
    std::vector<ImVec2> outline{};
    ImVec2 from;
    ImVec2 to;
    ImU32 to_colour = 0;
};

using Form = std::variant<Rect, Polylines, Polygons, Circle, GradientPolygon, TextRun>;

struct Shape {
    Form form;
    ImU32 colour = 0;
    std::optional<Rect> clip{};  // only where something is cut off
};

std::vector<Shape> shapes_of(const ImDrawData& frame, const Fonts& fonts);

}  // namespace tact
