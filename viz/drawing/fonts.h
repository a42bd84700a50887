// Type: Inter where it is installed, DejaVu Sans for what Inter lacks, further system fonts for
// the scripts that names are written in.
//
// Five sizes: fine print, label, body (titles in semibold), value, headline; and a body for those
// at the back of a room. All are on whole pixels at any scale, so that no line is blurred.
//
// Valid     characters up to U+FFFF (what a stock ImGui build can hold)
// Left out  shaping and right-to-left order (ImGui has neither), colour emoji.
#pragma once

#include <imgui.h>

#include <array>
#include <string>
#include <string_view>

namespace tact {

// Anti-aliased discs in the font texture: a circle as one quad is several times cheaper than one of
// triangles. Each entry is (u0, v0, u1, v1) of a disc of kDiscRadiiPx with 1 px margin around it.
inline constexpr std::array<int, 4> kDiscRadiiPx{4, 8, 16, 32};

// The ladder of type, px at a scale of 1. Nothing is set in another size.
struct TypeLadder {
    float fine = 12.0F;
    float small = 13.0F;
    float body = 15.0F;
    float presented = 17.0F;
    float large = 20.0F;
    float headline = 28.0F;
};

struct Fonts {
    ImFont* regular = nullptr;                          // body: text and numbers
    ImFont* semibold = nullptr;                         // body: what stands out of it
    ImFont* title = nullptr;                            // the same: of panes and dialogs
    ImFont* presented = nullptr;                        // a lesson's text before a class
    ImFont* small = nullptr;                            // label: axes, units, captions
    ImFont* fine = nullptr;                             // fine print: hints
    ImFont* large = nullptr;                            // value: large words and numbers
    ImFont* headline = nullptr;                         // the numbers one looks for first, Latin-1
    float em = 1.0F;                                    // of all fonts, over their line height
    std::array<ImVec4, kDiscRadiiPx.size()> disc_uv{};  // all zero: no discs, triangles are used
};

// The characters of a UTF-8 text that the font has no glyph for, each once, in order; steering
// ones (model/text/shown_text.h) have none to be drawn.
std::u32string without_glyph(const ImFont& font, std::string_view text);

// The Debian package to install for such characters, in words: "The package fonts-nanum".
const char* package_for(std::u32string_view characters);

// Fills an empty atlas and builds it. Glyphs: Latin-1, Latin Extended-A, Greek, punctuation,
// arrows, the shapes the program draws, and every character of `extra_text` (UTF-8) that some
// installed font has. Falls back to ImGui's own font. Digits get equal widths in all fonts, so that
// live numbers do not dance.
Fonts load_fonts(ImFontAtlas& atlas, float scale, const std::string& extra_text);

}  // namespace tact
