// Type: Inter where it is installed, DejaVu Sans for what Inter lacks, further system fonts for
// the scripts that names are written in.
//
// Five roles: title, value, body, label, fine print; and a body for those at the back of a room.
//
// Titles are a little above the body, and labels on whole pixels at any scale, so that no line is
// blurred.
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

struct Fonts {
    ImFont* regular = nullptr;                          // 15 px, body: text and numbers
    ImFont* semibold = nullptr;                         // 15 px: what stands out of the body
    ImFont* title = nullptr;                            // 17 px: of panes and dialogs
    ImFont* presented = nullptr;                        // 17 px: a lesson's text before a class
    ImFont* small = nullptr;                            // 13 px, label: axes, units, captions
    ImFont* fine = nullptr;                             // 12 px, fine print: hints
    ImFont* large = nullptr;                            // 20 px, value: headline numbers
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
