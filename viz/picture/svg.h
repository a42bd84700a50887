// A drawn frame as an SVG picture: shapes stay shapes and text stays text.
//
// Source    SVG 1.1 (2nd edition); paint-order: SVG 2.
// Input     a frame drawn with the style's anti-aliasing off; viewers smooth the edges themselves
// Output    UTF-8; one element a shape (a colour where cells are thousands), lengths to 1/100 px.
//           Text is set glyph by glyph in Inter or else a sans serif: it stays in place, and can be
//           searched and selected.
// Left out  embedded fonts; see frame_shapes.h for what is not read from a frame.
// Exact     same frame, same bytes.
#pragma once

#include <imgui.h>

#include <string>

#include "model/common/expected.h"
#include "viz/drawing/fonts.h"

namespace tact {

// The frame on a ground of one colour. `ids` begins the names of what is defined in it: several
// pictures in one page need names of their own.
std::string svg_text(const ImDrawData& frame, const Fonts& fonts, ImU32 ground,
                     const std::string& ids = {});

// A failed write leaves an existing file as it was.
Expected<Done> write_svg(const std::string& path, const std::string& text);

}  // namespace tact
