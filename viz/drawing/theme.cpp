#include "viz/drawing/theme.h"

#include <algorithm>

#include "viz/drawing/colour.h"

namespace tact {
namespace {

Theme sized(Theme theme, float scale) {
    theme.scale = scale;
    theme.padding_px = 12.0F * scale;
    theme.gap_px = 8.0F * scale;
    theme.rounding_px = 4.0F * scale;
    theme.pane_rounding_px = 6.0F * scale;
    theme.splitter_px = 6.0F * scale;
    theme.hairline_px = std::max(1.0F, scale);
    theme.trace_px = 1.25F * scale;
    theme.mark_px = 4.0F * scale;
    return theme;
}

ImVec4 vec(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

void apply_sizes(const Theme& theme, ImGuiStyle& style) {
    const float s = theme.scale;
    style.WindowPadding = {12 * s, 12 * s};
    style.FramePadding = {8 * s, 5 * s};
    style.ItemSpacing = {8 * s, 6 * s};
    style.ItemInnerSpacing = {6 * s, 4 * s};
    style.CellPadding = {6 * s, 3 * s};
    style.IndentSpacing = 16 * s;
    style.ScrollbarSize = 10 * s;
    style.GrabMinSize = 10 * s;
    style.WindowMinSize = {32 * s, 32 * s};
    style.WindowRounding = theme.pane_rounding_px;
    style.ChildRounding = theme.pane_rounding_px;
    style.PopupRounding = theme.pane_rounding_px;
    style.FrameRounding = theme.rounding_px;
    style.GrabRounding = 3 * s;
    style.TabRounding = theme.rounding_px;
    style.ScrollbarRounding = 5 * s;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = theme.hairline_px;  // menus within menus are children, too
    style.FrameBorderSize = theme.hairline_px;
    style.TabBorderSize = 0;
    style.PopupBorderSize = theme.hairline_px;
    style.WindowTitleAlign = {0.0F, 0.5F};
    style.WindowMenuButtonPosition = ImGuiDir_None;
}

void apply_colours(const Theme& theme, ImGuiStyle& style) {
    const ImU32 none = 0;
    const ImU32 tinted = mixed(theme.pane, theme.accent, 0.30F);
    const ImU32 chosen = mixed(theme.pane, theme.text, 0.16F);  // a selection, of whatever
    const ImU32 tinted_more = mixed(theme.pane, theme.accent, 0.45F);
    const auto set = [&](ImGuiCol slot, ImU32 colour) { style.Colors[slot] = vec(colour); };
    set(ImGuiCol_Text, theme.text);
    set(ImGuiCol_TextDisabled, theme.dim_text);
    set(ImGuiCol_WindowBg, theme.pane);
    set(ImGuiCol_ChildBg, none);
    set(ImGuiCol_PopupBg, theme.pane);
    set(ImGuiCol_Border, mixed(theme.line, theme.dim_text, 0.35F));  // of fields and windows
    set(ImGuiCol_BorderShadow, none);
    set(ImGuiCol_FrameBg, theme.field);
    set(ImGuiCol_FrameBgHovered, theme.hover);
    set(ImGuiCol_FrameBgActive, theme.hover);
    set(ImGuiCol_TitleBg, theme.pane);
    set(ImGuiCol_TitleBgActive, theme.pane);
    set(ImGuiCol_TitleBgCollapsed, theme.pane);
    set(ImGuiCol_MenuBarBg, theme.background);
    set(ImGuiCol_ScrollbarBg, none);
    set(ImGuiCol_ScrollbarGrab, theme.line);
    set(ImGuiCol_ScrollbarGrabHovered, mixed(theme.line, theme.dim_text, 0.5F));
    set(ImGuiCol_ScrollbarGrabActive, theme.dim_text);
    set(ImGuiCol_CheckMark, theme.accent);
    set(ImGuiCol_SliderGrab, theme.accent);
    set(ImGuiCol_SliderGrabActive, theme.accent);
    set(ImGuiCol_Button, theme.field);
    set(ImGuiCol_ButtonHovered, theme.hover);
    set(ImGuiCol_ButtonActive, tinted);
    set(ImGuiCol_Header, chosen);
    set(ImGuiCol_HeaderHovered, theme.hover);
    set(ImGuiCol_HeaderActive, chosen);
    set(ImGuiCol_Separator, theme.line);
    set(ImGuiCol_SeparatorHovered, theme.accent);
    set(ImGuiCol_SeparatorActive, theme.accent);
    set(ImGuiCol_ResizeGrip, none);
    set(ImGuiCol_ResizeGripHovered, theme.hover);
    set(ImGuiCol_ResizeGripActive, theme.accent);
    set(ImGuiCol_Tab, none);
    set(ImGuiCol_TabHovered, theme.hover);
    set(ImGuiCol_TabActive, tinted);
    set(ImGuiCol_TabUnfocused, none);
    set(ImGuiCol_TabUnfocusedActive, theme.field);
    set(ImGuiCol_PlotLines, theme.accent);
    set(ImGuiCol_PlotLinesHovered, theme.text);
    set(ImGuiCol_PlotHistogram, theme.accent);
    set(ImGuiCol_PlotHistogramHovered, theme.text);
    set(ImGuiCol_TableHeaderBg, theme.field);
    set(ImGuiCol_TableBorderStrong, theme.line);
    set(ImGuiCol_TableBorderLight, theme.line);
    set(ImGuiCol_TableRowBg, none);
    set(ImGuiCol_TableRowBgAlt, faded(theme.field, 0.4F));
    set(ImGuiCol_TextSelectedBg, tinted_more);
    set(ImGuiCol_DragDropTarget, theme.accent);
    set(ImGuiCol_NavHighlight, 0);  // the window frames the focus itself: of every kind of item
    set(ImGuiCol_NavWindowingHighlight, theme.accent);
    set(ImGuiCol_NavWindowingDimBg, faded(theme.background, 0.6F));
    set(ImGuiCol_ModalWindowDimBg, faded(IM_COL32_BLACK, theme.is_dark ? 0.5F : 0.3F));
}

}  // namespace

Theme dark_theme(float scale) {
    Theme theme;
    theme.is_dark = true;
    theme.background = rgb(0x15181C);
    theme.pane = rgb(0x1B1F24);
    theme.field = rgb(0x242A31);
    theme.hover = rgb(0x2E353E);
    theme.line = rgb(0x323A44);
    theme.text = rgb(0xE6E9ED);
    theme.dim_text = rgb(0x9AA4AF);
    theme.accent = rgb(0xA29DFF);  // no blue: 56B4E9 is the Meissner's, and a pattern's
    theme.series = rgb(0xC3CBD4);
    theme.warning = rgb(0xFFC078);  // lighter than E69F00, the Pacinian's, and a pattern's
    theme.error = rgb(0xE6564E);    // its contrast is 4.5
    theme.receptor = {rgb(0x56B4E9), rgb(0xE69F00), rgb(0x009E73), rgb(0xCC79A7)};
    // Okabe-Ito; black, the eighth, is a light grey here.
    theme.pattern = {rgb(0x56B4E9), rgb(0xE69F00), rgb(0x009E73), rgb(0xF0E442),
                     rgb(0x0E7FC0), rgb(0xD55E00), rgb(0xCC79A7), rgb(0xB8BCC2)};
    return sized(theme, scale);
}

// On white the same hues are darker: lines need a contrast of 3, receptor names (text) 4.5.
Theme light_theme(float scale) {
    Theme theme;
    theme.is_dark = false;
    theme.background = rgb(0xF4F5F7);
    theme.pane = rgb(0xFFFFFF);
    theme.field = rgb(0xEBEDF0);
    theme.hover = rgb(0xE0E4E9);
    theme.line = rgb(0xD5D9DE);
    theme.text = rgb(0x1C2126);
    theme.dim_text = rgb(0x5B6570);
    theme.accent = rgb(0x5A4FCF);
    theme.series = rgb(0x46505B);
    theme.warning = rgb(0x9C3C00);
    theme.error = rgb(0xC0332B);
    theme.receptor = {rgb(0x1479B0), rgb(0x946600), rgb(0x007D5B), rgb(0xA84F7F)};
    theme.pattern = {rgb(0x3595CF), rgb(0xC98300), rgb(0x009E73), rgb(0xA89C00),
                     rgb(0x00568A), rgb(0xD55E00), rgb(0xBC6394), rgb(0x4A5058)};
    return sized(theme, scale);
}

void apply(const Theme& theme, ImGuiStyle& style) {
    apply_sizes(theme, style);
    apply_colours(theme, style);
}

PatternLook pattern_look(const Theme& theme, std::size_t index) {
    return {theme.pattern[index % kPatternColourCount], index / kPatternColourCount % 2 == 1};
}

std::optional<std::size_t> palette_place(std::string_view colour) {
    const std::optional<ImU32> own = parse_colour(colour);
    for (std::size_t k = 0; own && k < kPatternColourCount; ++k) {
        if (parse_colour(kPatternColours[k].hex) == own) return k;
    }
    return std::nullopt;
}

std::optional<ImU32> shown_colour(const Theme& theme, std::string_view colour) {
    const std::optional<ImU32> own = parse_colour(colour);
    if (!own) return std::nullopt;
    if (const auto place = palette_place(colour)) return theme.pattern[*place];
    constexpr double kSeen = 3.0;
    constexpr int kShades = 16;
    for (int k = 0; k < kShades; ++k) {
        const ImU32 shade = mixed(*own, theme.text, static_cast<float>(k) / kShades);
        if (contrast(shade, theme.pane) >= kSeen) return shade;
    }
    return theme.text;
}

}  // namespace tact
