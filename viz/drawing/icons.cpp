#include "viz/drawing/icons.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tact {

namespace {

void draw_triangle(ImDrawList& list, ImVec2 centre, float size, float way, ImU32 colour) {
    const float half = size * 0.5F;
    list.AddTriangleFilled({centre.x - way * half, centre.y - half},
                           {centre.x + way * half, centre.y},
                           {centre.x - way * half, centre.y + half}, colour);
}

// An envelope over its time and its mirror image, filled between; `share` of the time is 0 to 1.
template <class Envelope>
void draw_swells(ImDrawList& list, ImVec2 centre, float size, ImU32 colour, Envelope envelope) {
    constexpr int kPieces = 32;
    const float left = centre.x - 0.75F * size;
    const float width = 1.5F * size;
    for (int k = 0; k < kPieces; ++k) {
        const auto at = [&](int place) {
            const float share = static_cast<float>(place) / kPieces;
            return ImVec2{left + share * width, std::max(0.04F, envelope(share)) * 0.5F * size};
        };
        const ImVec2 a = at(k);
        const ImVec2 b = at(k + 1);
        list.AddQuadFilled({a.x, centre.y - a.y}, {b.x, centre.y - b.y}, {b.x, centre.y + b.y},
                           {a.x, centre.y + a.y}, colour);
    }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 at, float size, ImU32 colour) {
    const float bar = size * 0.22F;
    const float half = size * 0.5F;
    const auto upright = [&](float x) {
        list.AddRectFilled({x - bar * 0.5F, at.y - half}, {x + bar * 0.5F, at.y + half}, colour);
    };
    const float stroke = std::max(1.0F, size * 0.13F);
    switch (icon) {
        case Icon::play:
            return draw_triangle(list, at, size, 1.0F, colour);
        case Icon::pause:
            upright(at.x - size * 0.25F);
            return upright(at.x + size * 0.25F);
        case Icon::stop:
            return list.AddRectFilled({at.x - half * 0.85F, at.y - half * 0.85F},
                                      {at.x + half * 0.85F, at.y + half * 0.85F}, colour);
        case Icon::to_start:
            upright(at.x - half);
            return draw_triangle(list, {at.x + bar * 0.5F, at.y}, size * 0.9F, -1.0F, colour);
        case Icon::back:
            upright(at.x + half);
            return draw_triangle(list, {at.x - bar, at.y}, size * 0.7F, -1.0F, colour);
        case Icon::forward:
            upright(at.x - half);
            return draw_triangle(list, {at.x + bar, at.y}, size * 0.7F, 1.0F, colour);
        case Icon::loop: {
            list.PathArcTo(at, half, -0.3F, 4.9F, 18);
            list.PathStroke(colour, ImDrawFlags_None, stroke);
            const ImVec2 tip{at.x + half * std::cos(4.9F), at.y + half * std::sin(4.9F)};
            return draw_triangle(list, tip, size * 0.5F, 1.0F, colour);
        }
        case Icon::ring:
            return draw_swells(list, at, size, colour, [](float share) {
                return std::abs(std::sin(2.0F * std::numbers::pi_v<float> * share));
            });
        case Icon::tremolo:
            return draw_swells(list, at, size, colour, [](float share) {
                return 0.62F - 0.38F * std::cos(2.0F * std::numbers::pi_v<float> * share);
            });
        case Icon::locked:
            list.AddRectFilled({at.x - 0.38F * size, at.y - 0.05F * size},
                               {at.x + 0.38F * size, at.y + half}, colour, 0.1F * size);
            list.PathLineTo({at.x - 0.24F * size, at.y});
            list.PathArcTo({at.x, at.y - 0.22F * size}, 0.24F * size, std::numbers::pi_v<float>,
                           2.0F * std::numbers::pi_v<float>, 10);
            list.PathLineTo({at.x + 0.24F * size, at.y});
            return list.PathStroke(colour, ImDrawFlags_None, stroke);
        case Icon::dropped: {
            const float radius = half - 0.5F * stroke;
            const float aslant = 0.7F * radius;
            list.AddCircle(at, radius, colour, 0, stroke);
            return list.AddLine({at.x - aslant, at.y + aslant}, {at.x + aslant, at.y - aslant},
                                colour, stroke);
        }
    }
}

}  // namespace tact
