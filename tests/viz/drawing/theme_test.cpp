#include "viz/drawing/theme.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "viz/drawing/colour.h"

namespace tact::theme_test {

TEST_CASE("theme: text of every kind stands out from its ground by 4.5 in both themes") {
    for (const Theme& theme : {dark_theme(1.0F), light_theme(1.0F)}) {
        for (const ImU32 ground : {theme.pane, theme.background}) {
            CHECK(contrast(theme.text, ground) >= 4.5);
            CHECK(contrast(theme.dim_text, ground) >= 4.5);
            CHECK(contrast(theme.accent, ground) >= 4.5);
            CHECK(contrast(theme.series, ground) >= 4.5);
            CHECK(contrast(theme.warning, ground) >= 4.5);
            CHECK(contrast(theme.error, ground) >= 4.5);
        }
        for (const ImU32 ground : {theme.field, theme.hover}) {
            CHECK(contrast(theme.text, ground) >= 4.5);
            CHECK(contrast(theme.dim_text, ground) >= 4.5);
        }
        for (const ImU32 receptor : theme.receptor) CHECK(contrast(receptor, theme.pane) >= 4.5);
    }
}

ImU32 styled(const ImGuiStyle& style, ImGuiCol slot) {
    return ImGui::ColorConvertFloat4ToU32(style.Colors[slot]);
}

TEST_CASE("theme: stock widgets can be read on every ground that they stand on, in both themes") {
    for (const Theme& theme : {dark_theme(1.0F), light_theme(1.0F)}) {
        CAPTURE(theme.is_dark);
        ImGuiStyle style;
        apply(theme, style);
        for (const ImGuiCol ground :
             {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered,
              ImGuiCol_FrameBgActive, ImGuiCol_TitleBgActive, ImGuiCol_MenuBarBg, ImGuiCol_Button,
              ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_Header,
              ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive, ImGuiCol_TableHeaderBg,
              ImGuiCol_TextSelectedBg}) {
            CAPTURE(ImGui::GetStyleColorName(ground));
            CHECK(contrast(theme.text, styled(style, ground)) >= 4.5);
        }
        // What shows a state or can be grabbed.
        for (const ImGuiCol mark : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab}) {
            CHECK(contrast(styled(style, mark), theme.field) >= 3.0);
        }
        // A field is told from what it stands on, a window over others by its edge.
        CHECK(styled(style, ImGuiCol_FrameBg) != styled(style, ImGuiCol_PopupBg));
        CHECK(contrast(styled(style, ImGuiCol_Border), theme.pane) >= 1.5);
        CHECK(contrast(theme.accent, readable_on(theme.accent)) >= 4.5);
    }
}

// How far two colours are apart, in steps of a channel: what differs by less is taken for the same.
int apart(ImU32 a, ImU32 b) {
    int most = 0;
    for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT}) {
        const auto channel = [shift](ImU32 colour) {
            return static_cast<int>((colour >> shift) & 0xFFU);
        };
        most = std::max(most, std::abs(channel(a) - channel(b)));
    }
    return most;
}

// All of them may stand in one pane.
TEST_CASE("theme: what can be pressed, warns or fails has the colour of no receptor and pattern") {
    constexpr int kLeast = 40;
    for (const Theme& theme : {dark_theme(1.0F), light_theme(1.0F)}) {
        CAPTURE(theme.is_dark);
        std::vector<ImU32> data(theme.receptor.begin(), theme.receptor.end());
        data.insert(data.end(), theme.pattern.begin(), theme.pattern.end());
        for (const ImU32 colour : data) {
            CAPTURE(colour);
            CHECK(apart(theme.accent, colour) >= kLeast);
            CHECK(apart(theme.warning, colour) >= kLeast);
        }
        CHECK(apart(theme.accent, theme.warning) >= kLeast);
        CHECK(apart(theme.accent, theme.error) >= kLeast);
        CHECK(apart(theme.accent, theme.series) >= kLeast);
        CHECK(apart(theme.warning, theme.error) >= kLeast);
    }
}

// 3 is what WCAG asks of graphics; yellow on white and black on black are the known traps. Two
// light colours, sky blue and orange, would turn muddy beyond 3 on white.
TEST_CASE("theme: every pattern's colour can be seen on the pane in both themes") {
    for (const Theme& theme : {dark_theme(1.0F), light_theme(1.0F)}) {
        for (const ImU32 colour : theme.pattern) CHECK(contrast(colour, theme.pane) >= 2.7);
    }
}

TEST_CASE("theme: the first sixteen patterns all look different") {
    const Theme theme = dark_theme(1.0F);
    for (std::size_t i = 0; i < 16; ++i) {
        CHECK(pattern_look(theme, i).ring == (i >= 8));
        for (std::size_t j = 0; j < i; ++j) CHECK(pattern_look(theme, i) != pattern_look(theme, j));
    }
}

TEST_CASE("theme: a colour of the palette has the theme's own shade, any other one can be seen") {
    for (const Theme& theme : {dark_theme(1.0F), light_theme(1.0F)}) {
        for (std::size_t k = 0; k < kPatternColourCount; ++k) {
            CHECK(palette_place(kPatternColours[k].hex) == k);
            CHECK(shown_colour(theme, kPatternColours[k].hex) == theme.pattern[k]);
        }
        CHECK(shown_colour(theme, "#d55e00") == theme.pattern[5]);
        for (const char* hex : {"#000000", "#FFFFFF", "#1B1F24", "#123456", "#FFFF00", "#808080"}) {
            REQUIRE(shown_colour(theme, hex));
            CHECK(contrast(*shown_colour(theme, hex), theme.pane) >= 3.0);
        }
        CHECK(shown_colour(theme, "#FF0000") == rgb(0xFF0000));  // seen well as it is
        CHECK_FALSE(shown_colour(theme, ""));
        CHECK_FALSE(shown_colour(theme, "red"));
    }
}

TEST_CASE("theme: all sizes grow with the scale") {
    const Theme one = dark_theme(1.0F);
    const Theme two = dark_theme(2.0F);
    CHECK(two.padding_px == 2.0F * one.padding_px);
    CHECK(two.hairline_px == 2.0F * one.hairline_px);
    ImGuiStyle small;
    ImGuiStyle large;
    apply(one, small);
    apply(two, large);
    CHECK(large.FramePadding.x == 2.0F * small.FramePadding.x);
    CHECK(large.WindowBorderSize == 0.0F);
}

}  // namespace tact::theme_test
