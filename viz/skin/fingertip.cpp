#include "viz/skin/fingertip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "viz/drawing/colour.h"

namespace tact {
namespace {

// The round end of the finger points up; toward the joint its sides are straighter.
double roundness(double y) { return y < 0.0 ? 2.1 : 2.9; }

ImVec2 fingertip_at(const SkinView& view, double turn_rad, double size) {
    const double c = std::cos(turn_rad);
    const double s = std::sin(turn_rad);
    const double power = 2.0 / roundness(s);
    const auto along = [&](double part) {
        return std::copysign(std::pow(std::abs(part), power), part);
    };
    return to_pixel(view, size * kFingertipWidthMm / 2.0 * along(c),
                    size * kFingertipLengthMm / 2.0 * along(s));
}

}  // namespace

// Tilted to 30 degrees above the skin; the probe moves down to make room for heights.
SkinView skin_view(const Rect& square, double half_extent_mm, float tilted) {
    const float t = std::clamp(tilted, 0.0F, 1.0F);
    const float pitch_rad = std::lerp(std::numbers::pi_v<float> / 2.0F, 0.52F, t);
    const float half_px = std::min(square.width(), square.height()) / 2.0F;
    SkinView view;
    view.probe_px = square.centre() + ImVec2{0.0F, 0.36F * t * half_px};
    view.px_per_mm = half_px / static_cast<float>(std::max(half_extent_mm, 0.1));
    view.height_px = t > 0.0F ? 1.35F * std::cos(pitch_rad) * half_px : 0.0F;
    view.yaw_rad = -0.3F * t;
    view.foreshorten = std::sin(pitch_rad);
    return view;
}

ImVec2 to_pixel(const SkinView& view, double x_mm, double y_mm, double raised) {
    const float x = static_cast<float>(x_mm) * view.px_per_mm;
    const float y = static_cast<float>(y_mm) * view.px_per_mm;
    const float c = std::cos(view.yaw_rad);
    const float s = std::sin(view.yaw_rad);
    return view.probe_px + ImVec2{x * c - y * s, (x * s + y * c) * view.foreshorten -
                                                     static_cast<float>(raised) * view.height_px};
}

bool is_on_fingertip(double x_mm, double y_mm) {
    const double power = roundness(y_mm);
    return std::pow(std::abs(2.0 * x_mm / kFingertipWidthMm), power) +
               std::pow(std::abs(2.0 * y_mm / kFingertipLengthMm), power) <=
           1.0;
}

ImU32 skin_colour(const Theme& theme) { return mixed(theme.pane, theme.field, 0.9F); }

// A disc of skin, lighter in the middle, with a soft edge.
void draw_fingertip(ImDrawList& list, const Theme& theme, const SkinView& view) {
    constexpr unsigned kSegments = 72;
    const ImU32 skin = skin_colour(theme);
    const ImU32 middle = theme.is_dark ? mixed(skin, theme.hover, 0.45F) : skin;
    struct Ring {
        double size;
        ImU32 colour;
    };
    const std::array<Ring, 3> rings{
        {{0.94, skin}, {1.0, mixed(skin, theme.line, 0.45F)}, {1.03, faded(skin, 0.0F)}}};
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(kSegments * (3 + 6 + 6), 1 + kSegments * 3);
    const unsigned base = list._VtxCurrentIdx;
    list.PrimWriteVtx(view.probe_px, uv, middle);
    for (const Ring& ring : rings) {
        for (unsigned i = 0; i < kSegments; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / kSegments;
            list.PrimWriteVtx(fingertip_at(view, turn, ring.size), uv, ring.colour);
        }
    }
    const auto triangle = [&](unsigned a, unsigned b, unsigned c) {
        for (const unsigned v : {a, b, c}) list.PrimWriteIdx(static_cast<ImDrawIdx>(v));
    };
    for (unsigned i = 0; i < kSegments; ++i) {
        const unsigned next = (i + 1) % kSegments;
        triangle(base, base + 1 + i, base + 1 + next);
        for (unsigned ring = 0; ring < 2; ++ring) {
            const unsigned inner = base + 1 + ring * kSegments;
            const unsigned outer = inner + kSegments;
            triangle(inner + i, outer + i, outer + next);
            triangle(inner + i, outer + next, inner + next);
        }
    }
}

void draw_skin_circle(ImDrawList& list, const SkinView& view, double radius_mm, double raised,
                      ImU32 colour, float width_px) {
    constexpr std::size_t kSegments = 64;
    std::array<ImVec2, kSegments> points;
    for (std::size_t i = 0; i < kSegments; ++i) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / kSegments;
        points[i] = to_pixel(view, radius_mm * std::cos(turn), radius_mm * std::sin(turn), raised);
    }
    list.AddPolyline(points.data(), static_cast<int>(kSegments), colour, ImDrawFlags_Closed,
                     width_px);
}

}  // namespace tact
