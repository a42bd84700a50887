// The look: every colour and size of the program, in a dark and a light version.
//
// Source    patterns: Okabe & Ito 2008; the rest was chosen by eye and by contrast.
// Left out  high-contrast and user-made themes.
#pragma once

#include <imgui.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>

#include "model/physiology/mechanoreceptor.h"
#include "viz/drawing/fonts.h"

namespace tact {

struct BodyCache;

inline constexpr std::size_t kPatternColourCount = 8;

// As a set keeps them; a theme shows each as it is seen best on its ground.
struct PatternColour {
    const char* name;
    const char* hex;
};
inline constexpr std::array<PatternColour, kPatternColourCount> kPatternColours{
    {{"Sky blue", "#56B4E9"},
     {"Orange", "#E69F00"},
     {"Green", "#009E73"},
     {"Yellow", "#F0E442"},
     {"Blue", "#0072B2"},
     {"Vermillion", "#D55E00"},
     {"Purple", "#CC79A7"},
     {"Grey", "#999999"}}};

struct Theme {
    bool is_dark = true;
    float scale = 1.0F;                 // of everything below
    Fonts fonts;                        // empty until load_fonts; ImGui's current font then
    std::shared_ptr<BodyCache> bodies;  // of what is drawn every frame; none: nothing is kept

    ImU32 background = 0;  // of the window, between panes
    ImU32 pane = 0;        // under all content
    ImU32 field = 0;       // of sliders, inputs, empty matrix cells
    ImU32 hover = 0;
    ImU32 line = 0;  // separators, grid
    ImU32 text = 0;
    ImU32 dim_text = 0;  // units, axis labels
    ImU32 accent = 0;    // of what can be pressed, moved or typed into, and of nothing else
    ImU32 series = 0;    // of data that belongs to no pattern and no receptor
    ImU32 warning = 0;
    ImU32 error = 0;
    PerReceptor<ImU32> receptor{};
    std::array<ImU32, kPatternColourCount> pattern{};

    float padding_px = 0;   // inside a pane
    float gap_px = 0;       // between neighbours
    float rounding_px = 0;  // of frames
    float pane_rounding_px = 0;
    float splitter_px = 0;
    float hairline_px = 0;  // the thinnest line
    float trace_px = 0;     // a curve
    float mark_px = 0;      // radius of a legend mark
};

// `scale` multiplies every size; 1 on an ordinary screen.
Theme dark_theme(float scale);
Theme light_theme(float scale);

// Makes stock widgets look like the rest.
void apply(const Theme& theme, ImGuiStyle& style);

// The mark of the i-th pattern: eight colours in order, the same ones as rings, and so on.
struct PatternLook {
    ImU32 colour = 0;
    bool ring = false;

    bool operator==(const PatternLook&) const = default;
};

PatternLook pattern_look(const Theme& theme, std::size_t index);

// Which of kPatternColours "#RRGGBB" is; none: another one, or no colour.
std::optional<std::size_t> palette_place(std::string_view colour);

// A colour that a set keeps, "#RRGGBB", as it is shown: one of the palette in the theme's own
// shade, another one at a contrast of 3 with the pane at least. None: it is no colour.
std::optional<ImU32> shown_colour(const Theme& theme, std::string_view colour);

}  // namespace tact
