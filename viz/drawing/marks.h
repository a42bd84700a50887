// Small things that several views draw: text, discs, the marks of patterns and receptors, the
// veil over stale content.
#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/physiology/mechanoreceptor.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

// The font, or ImGui's current one where a theme has none yet.
const ImFont& font_or_current(const ImFont* font);

ImVec2 text_size(const ImFont* font, std::string_view text);
void draw_text(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour,
               std::string_view text);

// Text in front of lines: the same text in `halo` around it, `width_px` wide.
void draw_text_halo(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour, ImU32 halo,
                    float width_px, std::string_view text);

// Text that reads upwards; `corner` is the lower left corner of the turned text.
void draw_text_upwards(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour,
                       std::string_view text);

// A width in whole pixels, at least one: sharp at any scale.
float whole_px(float width_px);

// Level and upright lines on whole pixels: sharp at any scale, which AddLine's are not.
void draw_level_line(ImDrawList& list, float y, float left, float right, float width_px,
                     ImU32 colour);
void draw_upright_line(ImDrawList& list, float x, float top, float bottom, float width_px,
                       ImU32 colour);

// An open line through any number of points. ImGui's own takes all of them at once on the stack and
// joins them by 16-bit indices: a long one crashes, or ends in a chord back to its beginning.
void draw_path(ImDrawList& list, std::span<const ImVec2> points, ImU32 colour, float width_px);

// The longest beginning of the text that fits, with "…" where something was cut.
std::string shortened(const ImFont* font, std::string_view text, float width_px);

// A filled circle: one textured quad where the theme's fonts have discs.
void draw_disc(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px, ImU32 colour);

// A disc, or a ring on `ground` from the ninth pattern on.
void draw_pattern_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                       const PatternLook& look, ImU32 ground);

// What is selected, in a list and in the map: two lines around it, of the strongest ink and of the
// ground, so that one of them is seen on whatever lies under it. No colour means anything here.
void draw_selection_ring(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px);
void draw_selection_frame(ImDrawList& list, const Theme& theme, const Rect& area);

// Meissner circle, Pacinian square, Merkel triangle, Ruffini diamond, all of equal area.
void draw_receptor_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                        Receptor receptor);
void draw_receptor_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                        Receptor receptor, ImU32 colour);

// Drawn over content that a running computation will replace: leaves 45 % of it, under a diagonal
// hatch that drifts slowly with `time_s` (constant: stands still).
void draw_stale(ImDrawList& list, const Theme& theme, const Rect& area, double time_s);

// The text in lines no wider than that, broken at spaces and where it breaks itself; a word that is
// wider is cut.
std::vector<std::string> wrapped(const ImFont* font, std::string_view text, float width_px);

// What a pane says while it has nothing to show: what it is, why it is empty, what to do.
void draw_empty(ImDrawList& list, const Theme& theme, const Rect& area, std::string_view title,
                std::string_view reason);

// A little plate with lines of text beside a point, always inside `bounds`.
void draw_readout(ImDrawList& list, const Theme& theme, const Rect& bounds, ImVec2 at,
                  std::span<const std::string> lines);

// How a list, a table or a text shares a pane with the picture that belongs to it.
//
// Left out  moving the border by hand.

struct WordsWanted {
    float least_px;   // narrower they cannot be read
    float most_px;    // wider they are no easier to read
    float height_px;  // all of them, at that width
};

struct WordsAndPicture {
    Rect words;
    Rect picture;  // empty: there is no room for it
};

// Beside each other, or the picture below, whichever lets the picture be larger: it has what the
// words leave, but is no higher than wide. Pure, for tests.
WordsAndPicture words_and_picture(const Rect& area, const WordsWanted& words,
                                  ImVec2 least_picture_px, float gap_px);

}  // namespace tact
