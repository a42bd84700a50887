// Reading drawn text back: from the quads that show pieces of the font texture to characters.
//
// Source    the layout of ImGui 1.86: pen positions on one baseline, a quad a visible glyph.
// Valid     level and turned text in any size of the theme's fonts, whole or cut by a fine clip
// Left out  gaps of more than one space: nothing tells them from two texts, so they end a run.
#pragma once

#include <imgui.h>

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "viz/drawing/fonts.h"
#include "viz/drawing/geometry.h"

namespace tact {

struct FontGlyph {
    const ImFont* font = nullptr;
    const ImFontGlyph* glyph = nullptr;
};

// All visible glyphs by the upper left corner of their place in the texture.
using GlyphIndex = std::map<std::pair<float, float>, FontGlyph>;
GlyphIndex glyph_index(const Fonts& fonts);

// Corners in ImGui's order: upper left, upper right, lower right, lower left, before any turning.
using TexturedQuad = std::array<ImDrawVert, 4>;

// One drawn glyph. Along and across are coordinates turned by `direction`, which text runs in.
struct DrawnGlyph {
    ImWchar character = 0;
    const ImFont* font = nullptr;
    float size_px = 0;  // of the font: its line height
    ImVec2 direction{1, 0};
    float along_px = 0;          // of the pen before the glyph
    float across_px = 0;         // of the baseline
    Rect box;                    // on the screen
    std::optional<Rect> kept{};  // what a fine clip left, unbounded on sides where it cut nothing
};

// Nothing for a quad that shows no glyph.
std::optional<DrawnGlyph> glyph_of(const GlyphIndex& index, const TexturedQuad& quad);

// Glyphs of one line of text, and what is left of it by clipping.
struct TextRun {
    std::vector<ImWchar> characters{};
    std::vector<float> along_px{};  // one a character
    float across_px = 0;
    ImVec2 direction{1, 0};
    const ImFont* font = nullptr;
    float size_px = 0;
    Rect box;
    std::optional<Rect> kept{};
    ImU32 halo = 0;  // behind the text; 0: none
    float halo_px = 0;
};

TextRun run_of(const DrawnGlyph& glyph);

// Adds the glyph, with the space before it, if it continues where the run ends.
bool extend(TextRun& run, const DrawnGlyph& glyph);

// Whether both say the same in the same type; then by how much they are apart, in pixels.
std::optional<float> offset_of_copy(const TextRun& a, const TextRun& b);

}  // namespace tact
