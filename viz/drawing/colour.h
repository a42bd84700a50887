// Colours as ImGui packs them (ImU32), and arithmetic on them.
//
// Source    contrast: WCAG 2.1, relative luminance of sRGB.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tact {

// An opaque colour from 0xRRGGBB.
constexpr ImU32 rgb(std::uint32_t hex) {
    return 0xFF000000U | ((hex & 0xFFU) << 16U) | (hex & 0xFF00U) | ((hex >> 16U) & 0xFFU);
}

// "#RRGGBB"; nothing for any other text.
std::optional<ImU32> parse_colour(std::string_view text);

// "#rrggbb", without the opacity.
std::string hex_text(ImU32 colour);

// The colour with its opacity multiplied, 0..1.
ImU32 faded(ImU32 colour, float opacity);

// From a (t = 0) to b (t = 1), all four components.
ImU32 mixed(ImU32 a, ImU32 b, float t);

// 0 (black) to 1 (white); opacity is ignored.
double luminance(ImU32 colour);

// 1 to 21; text wants 4.5, graphics 3.
double contrast(ImU32 a, ImU32 b);

// Black or white, whichever reads better on `ground`.
ImU32 readable_on(ImU32 ground);

}  // namespace tact
