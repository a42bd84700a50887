// Outlines of flat triangle meshes.
//
// Valid     meshes whose triangles all turn the same way, as ImGui's do
#pragma once

#include <imgui.h>

#include <vector>

namespace tact {

using Outline = std::vector<ImVec2>;

// The directed edges of the triangles (three indices into the vertices each) that no neighbour runs
// back along, joined. Holes and islands are outlines of their own; successive corners in one place
// are one.
std::vector<Outline> outlines_of(const std::vector<ImDrawIdx>& triangles, const ImDrawVert* v);

// Clockwise on the screen.
void make_clockwise(Outline& outline);

}  // namespace tact
