// The software half of picture.h: triangles and upright rectangles, blended over an image.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "viz/picture/picture.h"

namespace tact {
namespace {

// Vertices snap to 1/256 px, so that edge functions are exact integers.
constexpr std::int64_t kSubpixel = 256;
constexpr std::int64_t kHalfPixel = kSubpixel / 2;

struct PixelBounds {
    int left, top, right, bottom;  // right and bottom excluded
};

using Rgba = std::array<float, 4>;  // 0..255

Rgba unpacked(ImU32 c) {
    return {static_cast<float>((c >> IM_COL32_R_SHIFT) & 0xFFU),
            static_cast<float>((c >> IM_COL32_G_SHIFT) & 0xFFU),
            static_cast<float>((c >> IM_COL32_B_SHIFT) & 0xFFU),
            static_cast<float>((c >> IM_COL32_A_SHIFT) & 0xFFU)};
}

// result = source a + destination (1 - a); the image's own opacity grows likewise.
void blend(Image& image, int x, int y, const Rgba& source, float cover) {
    const float a = source[3] / 255.0F * cover;
    if (a <= 0.0F) return;
    std::uint8_t* to =
        &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x))];
    for (std::size_t i = 0; i < 3; ++i) {
        const auto under = static_cast<float>(to[i]);
        to[i] = static_cast<std::uint8_t>(under + (source[i] - under) * a + 0.5F);
    }
    const auto under = static_cast<float>(to[3]);
    to[3] = static_cast<std::uint8_t>(under + (255.0F - under) * a + 0.5F);
}

// Bilinear, clamped to the edge, 0..1.
float sampled(const AlphaTexture& texture, float u, float v) {
    const float x = u * static_cast<float>(texture.width) - 0.5F;
    const float y = v * static_cast<float>(texture.height) - 0.5F;
    const float x0 = std::floor(x);
    const float y0 = std::floor(y);
    const auto at = [&](float px, float py) {
        const int cx = std::clamp(static_cast<int>(px), 0, texture.width - 1);
        const int cy = std::clamp(static_cast<int>(py), 0, texture.height - 1);
        return static_cast<float>(texture.alpha[cy * texture.width + cx]);
    };
    const float fx = x - x0;
    const float fy = y - y0;
    const float upper = at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx;
    const float lower = at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx;
    return (upper * (1 - fy) + lower * fy) / 255.0F;
}

std::int64_t snapped(float v) {
    return std::llround(std::clamp(v, -1e6F, 1e6F) * static_cast<float>(kSubpixel));
}

// The first pixel whose centre is at or after a coordinate.
int first_pixel(std::int64_t coordinate) {
    const std::int64_t shifted = coordinate - kHalfPixel;
    return static_cast<int>(shifted >= 0 ? (shifted + kSubpixel - 1) / kSubpixel
                                         : -(-shifted / kSubpixel));
}

// One edge a -> b of a clockwise triangle (on the screen): positive inside.
struct Edge {
    std::int64_t dx, dy, value;  // value at the first pixel's centre, shifted by the fill rule

    Edge(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, std::int64_t px,
         std::int64_t py)
        : dx(bx - ax), dy(by - ay), value(dx * (py - ay) - dy * (px - ax)) {
        const bool top_or_left = (dy == 0 && dx > 0) || dy < 0;
        if (!top_or_left) value -= 1;  // centres on this edge belong to the neighbour
    }
};

bool inside(const std::array<std::int64_t, 3>& w) { return w[0] >= 0 && w[1] >= 0 && w[2] >= 0; }

void fill_triangle(Image& image, const AlphaTexture& texture, const PixelBounds& clip,
                   const ImDrawVert* a, const ImDrawVert* b, const ImDrawVert* c) {
    struct Point {
        std::int64_t x, y;
    };
    const auto point = [](const ImDrawVert* v) {
        return Point{snapped(v->pos.x), snapped(v->pos.y)};
    };
    Point pa = point(a);
    Point pb = point(b);
    Point pc = point(c);
    std::int64_t area = (pb.x - pa.x) * (pc.y - pa.y) - (pb.y - pa.y) * (pc.x - pa.x);
    if (area == 0) return;
    if (area < 0) {
        std::swap(b, c);
        std::swap(pb, pc);
        area = -area;
    }
    const int left = std::max(clip.left, first_pixel(std::min({pa.x, pb.x, pc.x})));
    const int right = std::min(clip.right, first_pixel(std::max({pa.x, pb.x, pc.x}) + 1));
    const int top = std::max(clip.top, first_pixel(std::min({pa.y, pb.y, pc.y})));
    const int bottom = std::min(clip.bottom, first_pixel(std::max({pa.y, pb.y, pc.y}) + 1));
    if (left >= right || top >= bottom) return;

    const std::int64_t x0 = left * kSubpixel + kHalfPixel;
    const std::int64_t y0 = top * kSubpixel + kHalfPixel;
    // Each edge's value is the weight of the vertex opposite to it.
    const std::array<Edge, 3> edges{Edge{pb.x, pb.y, pc.x, pc.y, x0, y0},
                                    Edge{pc.x, pc.y, pa.x, pa.y, x0, y0},
                                    Edge{pa.x, pa.y, pb.x, pb.y, x0, y0}};
    const std::array<const ImDrawVert*, 3> corners{a, b, c};
    const std::array<Rgba, 3> colours{unpacked(a->col), unpacked(b->col), unpacked(c->col)};
    const bool one_texel =
        a->uv.x == b->uv.x && a->uv.x == c->uv.x && a->uv.y == b->uv.y && a->uv.y == c->uv.y;
    const float cover = one_texel ? sampled(texture, a->uv.x, a->uv.y) : 0.0F;

    std::array<std::int64_t, 3> row{edges[0].value, edges[1].value, edges[2].value};
    for (int y = top; y < bottom; ++y) {
        std::array<std::int64_t, 3> w = row;
        for (int x = left; x < right; ++x) {
            if (inside(w)) {
                Rgba colour{};
                float u = 0;
                float v = 0;
                for (std::size_t i = 0; i < 3; ++i) {
                    const float share = static_cast<float>(w[i]) / static_cast<float>(area);
                    for (std::size_t k = 0; k < 4; ++k) colour[k] += share * colours[i][k];
                    u += share * corners[i]->uv.x;
                    v += share * corners[i]->uv.y;
                }
                blend(image, x, y, colour, one_texel ? cover : sampled(texture, u, v));
            }
            for (std::size_t i = 0; i < 3; ++i) w[i] -= edges[i].dy * kSubpixel;
        }
        for (std::size_t i = 0; i < 3; ++i) row[i] += edges[i].dx * kSubpixel;
    }
}

// The six indices of an upright rectangle of one colour, as ImGui's PrimRect writes them.
bool is_upright_rect(const ImDrawIdx* index, const ImDrawVert* v) {
    if (index[0] != index[3] || index[2] != index[4]) return false;
    const ImDrawVert& a = v[index[0]];
    const ImDrawVert& b = v[index[1]];
    const ImDrawVert& c = v[index[2]];
    const ImDrawVert& d = v[index[5]];
    return a.pos.y == b.pos.y && b.pos.x == c.pos.x && c.pos.y == d.pos.y && d.pos.x == a.pos.x &&
           a.uv.y == b.uv.y && b.uv.x == c.uv.x && c.uv.y == d.uv.y && d.uv.x == a.uv.x &&
           a.col == b.col && a.col == c.col && a.col == d.col && a.pos.x < c.pos.x &&
           a.pos.y < c.pos.y;
}

void fill_rect(Image& image, const AlphaTexture& texture, const PixelBounds& clip,
               const ImDrawVert& a, const ImDrawVert& c) {
    const int left = std::max(clip.left, first_pixel(snapped(a.pos.x)));
    const int right = std::min(clip.right, first_pixel(snapped(c.pos.x)));
    const int top = std::max(clip.top, first_pixel(snapped(a.pos.y)));
    const int bottom = std::min(clip.bottom, first_pixel(snapped(c.pos.y)));
    const Rgba colour = unpacked(a.col);
    const bool one_texel = a.uv.x == c.uv.x && a.uv.y == c.uv.y;
    const float cover = one_texel ? sampled(texture, a.uv.x, a.uv.y) : 0.0F;
    const float du = (c.uv.x - a.uv.x) / (c.pos.x - a.pos.x);
    const float dv = (c.uv.y - a.uv.y) / (c.pos.y - a.pos.y);
    for (int y = top; y < bottom; ++y) {
        const float v = a.uv.y + (static_cast<float>(y) + 0.5F - a.pos.y) * dv;
        for (int x = left; x < right; ++x) {
            const float u = a.uv.x + (static_cast<float>(x) + 0.5F - a.pos.x) * du;
            blend(image, x, y, colour, one_texel ? cover : sampled(texture, u, v));
        }
    }
}

void draw_command(Image& image, const AlphaTexture& texture, const ImDrawList& list,
                  const ImDrawCmd& command, ImVec2 origin) {
    const auto bound = [](float v, int most) {
        return static_cast<int>(std::clamp(v, 0.0F, static_cast<float>(most)));
    };
    const PixelBounds clip{bound(command.ClipRect.x - origin.x, image.width),
                           bound(command.ClipRect.y - origin.y, image.height),
                           bound(command.ClipRect.z - origin.x, image.width),
                           bound(command.ClipRect.w - origin.y, image.height)};
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawIdx* end = index + command.ElemCount;
    while (index + 3 <= end) {
        if (index + 6 <= end && is_upright_rect(index, vertices)) {
            fill_rect(image, texture, clip, vertices[index[0]], vertices[index[2]]);
            index += 6;
            continue;
        }
        fill_triangle(image, texture, clip, &vertices[index[0]], &vertices[index[1]],
                      &vertices[index[2]]);
        index += 3;
    }
}

}  // namespace

void rasterise(const ImDrawData& frame, const AlphaTexture& texture, Image& image) {
    IM_ASSERT(frame.DisplayPos.x == 0.0F && frame.DisplayPos.y == 0.0F && "one picture, no offset");
    for (int i = 0; i < frame.CmdListsCount; ++i) {
        const ImDrawList& list = *frame.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback == nullptr) {
                draw_command(image, texture, list, command, frame.DisplayPos);
            }
        }
    }
}

}  // namespace tact
