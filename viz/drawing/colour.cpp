#include "viz/drawing/colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

namespace {

constexpr int kSteps = 256;
using Table = std::array<ImU32, kSteps>;

// Evenly spaced control points to one colour a step.
template <std::size_t n>
Table interpolated(const std::array<std::uint32_t, n>& control_hex) {
    Table table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float at = static_cast<float>(i) / (kSteps - 1) * static_cast<float>(n - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(at), n - 2);
        table[i] = mixed(rgb(control_hex[below]), rgb(control_hex[below + 1]),
                         at - static_cast<float>(below));
    }
    return table;
}

ImU32 step_of(const Table& table, double t) {
    const double inside = t > 0.0 ? std::min(t, 1.0) : 0.0;  // NaN compares false
    return table[static_cast<std::size_t>(std::lround(inside * (kSteps - 1)))];
}

}  // namespace

ImU32 viridis(double t) {
    static const Table table = interpolated(
        std::array<std::uint32_t, 11>{0x440154, 0x482475, 0x414487, 0x355F8D, 0x2A788E, 0x21918C,
                                      0x22A884, 0x44BF70, 0x7AD151, 0xBDDF26, 0xFDE725});
    return step_of(table, t);
}

ImU32 cividis(double t) {
    static const Table table = interpolated(std::array<std::uint32_t, 9>{
        0x00224E, 0x123570, 0x3B496C, 0x575D6D, 0x707173, 0x8A8678, 0xA59C74, 0xC3B369, 0xFEE838});
    return step_of(table, t);
}

ImU32 closeness_colour(double share) { return cividis(1.0 - share); }

ImU32 MarkColours::operator()(double t) const {
    return viridis(from + (to - from) * (t > 0.0 ? std::min(t, 1.0) : 0.0));
}

MarkColours mark_colours(ImU32 ground) {
    constexpr double kSeen = 3.0;
    constexpr int kTried = 256;
    const auto is_seen = [ground](double t) { return contrast(viridis(t), ground) >= kSeen; };
    MarkColours colours;
    for (int k = 0; k < kTried && !is_seen(colours.from); ++k) colours.from += 1.0 / kTried;
    for (int k = 0; k < kTried && !is_seen(colours.to); ++k) colours.to -= 1.0 / kTried;
    return colours.from < colours.to ? colours : MarkColours{};
}

ImU32 diverging(double t) {
    static const Table table = interpolated(
        std::array<std::uint32_t, 5>{0x0072B2, 0x7FB8DC, 0xF7F7F7, 0xF0B27A, 0xD55E00});
    return step_of(table, std::isnan(t) ? 0.5 : (t + 1.0) / 2.0);
}

}  // namespace tact
