#include "viz/drawing/colour.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tact {
namespace {

float component(ImU32 colour, unsigned shift) {
    return static_cast<float>((colour >> shift) & 0xFFU);
}

ImU32 packed(float value, unsigned shift) {
    return static_cast<ImU32>(std::clamp(value, 0.0F, 255.0F) + 0.5F) << shift;
}

double linear(ImU32 colour, unsigned shift) {
    const double s = component(colour, shift) / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace

std::optional<ImU32> parse_colour(std::string_view text) {
    if (text.size() != 7 || text.front() != '#') return std::nullopt;
    std::uint32_t hex = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data() + 1, end, hex, 16);
    if (fault != std::errc{} || stop != end) return std::nullopt;
    return rgb(hex);
}

std::string hex_text(ImU32 colour) {
    std::string text = "#";
    for (const unsigned shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT}) {
        for (const unsigned half : {4U, 0U}) {
            text += "0123456789abcdef"[(colour >> shift >> half) & 0xFU];
        }
    }
    return text;
}

ImU32 faded(ImU32 colour, float opacity) {
    const float alpha = component(colour, IM_COL32_A_SHIFT) * opacity;
    return (colour & ~IM_COL32_A_MASK) | packed(alpha, IM_COL32_A_SHIFT);
}

ImU32 mixed(ImU32 a, ImU32 b, float t) {
    ImU32 result = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        const float from = component(a, shift);
        result |= packed(from + (component(b, shift) - from) * t, shift);
    }
    return result;
}

double luminance(ImU32 colour) {
    return 0.2126 * linear(colour, IM_COL32_R_SHIFT) + 0.7152 * linear(colour, IM_COL32_G_SHIFT) +
           0.0722 * linear(colour, IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

ImU32 readable_on(ImU32 ground) {
    return contrast(ground, IM_COL32_WHITE) >= contrast(ground, IM_COL32_BLACK) ? IM_COL32_WHITE
                                                                                : IM_COL32_BLACK;
}

}  // namespace tact
