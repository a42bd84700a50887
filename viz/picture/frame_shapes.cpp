#include "viz/picture/frame_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viz/picture/shape_joining.h"

namespace tact {
namespace {

struct Reading {
    const Fonts& fonts;
    GlyphIndex glyphs;
    ShapeJoining joining{};
};

bool clear(ImU32 colour) { return (colour & IM_COL32_A_MASK) == 0; }

bool one_texel(const ImDrawIdx* t, const ImDrawVert* v) {
    return same(v[t[0]].uv, v[t[1]].uv) && same(v[t[0]].uv, v[t[2]].uv);
}

bool one_colour(const ImDrawIdx* t, const ImDrawVert* v) {
    return v[t[0]].col == v[t[1]].col && v[t[0]].col == v[t[2]].col;
}

// A triangle of nothing: clear, or the soft edge of something drawn without one.
bool invisible(const ImDrawIdx* t, const ImDrawVert* v) {
    if (clear(v[t[0]].col) && clear(v[t[1]].col) && clear(v[t[2]].col)) return true;
    const ImVec2 ab = v[t[1]].pos - v[t[0]].pos;
    const ImVec2 ac = v[t[2]].pos - v[t[0]].pos;
    return !one_colour(t, v) && ab.x * ac.y - ab.y * ac.x == 0.0F;
}

bool is_quad(const ImDrawIdx* t) { return t[3] == t[0] && t[4] == t[2]; }

std::ptrdiff_t read_textured(Reading& reading, const ImDrawIdx* t, const ImDrawIdx* end,
                             const ImDrawVert* v) {
    if (end - t < 6 || !is_quad(t)) return 3;
    const TexturedQuad quad{v[t[0]], v[t[1]], v[t[2]], v[t[5]]};
    const ImU32 colour = quad[0].col;
    if (clear(colour)) return 6;
    for (std::size_t i = 0; i < kDiscRadiiPx.size(); ++i) {
        const ImVec4& uv = reading.fonts.disc_uv[i];
        if (!same(quad[0].uv, {uv.x, uv.y}) || !same(quad[2].uv, {uv.z, uv.w})) continue;
        end_all(reading.joining);
        const auto baked_px = static_cast<float>(kDiscRadiiPx[i]);
        const float half = (quad[2].pos.x - quad[0].pos.x) / 2.0F;
        const Circle circle{(quad[0].pos + quad[2].pos) * 0.5F,
                            half * baked_px / (baked_px + 1.0F)};
        add_circle(reading.joining, circle, colour);
        return 6;
    }
    if (const auto glyph = glyph_of(reading.glyphs, quad))
        add_glyph(reading.joining, *glyph, colour);
    return 6;
}

ImU32 mean_colour(const std::vector<ImU32>& colours) {
    ImU32 mean = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) {
        std::size_t sum = 0;
        for (const ImU32 c : colours) sum += (c >> shift) & 0xFFU;
        mean |= static_cast<ImU32>((sum + colours.size() / 2) / colours.size()) << shift;
    }
    return mean;
}

// Two opposite sides of a quad of one colour each, or a corner opposite to a side of one colour,
// make a gradient; other mixtures become their mean.
void add_mixture(ShapeJoining& joining, const Outline& outline, const std::vector<ImU32>& colours) {
    end_all(joining);
    const Clipping cut = clipping(joining.clip, bounds_of(outline, 0.0F));
    if (cut.nothing_left) return;
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const std::size_t k = (i + 2) % n;
        const std::size_t l = (i + 3) % n;  // in a triangle: i again
        if (colours[i] != colours[j] || (n == 4 && colours[k] != colours[l])) continue;
        const ImVec2 from = (outline[i] + outline[j]) * 0.5F;
        ImVec2 to = n == 4 ? (outline[k] + outline[l]) * 0.5F : outline[k];
        // Colour is constant along the first side: continue at a right angle to it.
        const ImVec2 side = outline[j] - outline[i];
        const float square = std::max(side.x * side.x + side.y * side.y, 1e-12F);
        const ImVec2 way = to - from;
        to = to - side * ((way.x * side.x + way.y * side.y) / square);
        joining.shapes.push_back(
            {GradientPolygon{outline, from, to, colours[k]}, colours[i], cut.clip});
        return;
    }
    joining.shapes.push_back({Polygons{{outline}}, mean_colour(colours), cut.clip});
}

std::ptrdiff_t read_mixture(Reading& reading, const ImDrawIdx* t, const ImDrawIdx* end,
                            const ImDrawVert* v) {
    const bool quad = end - t >= 6 && is_quad(t) && one_texel(t + 3, v);
    Outline outline;
    std::vector<ImU32> colours;
    for (const std::ptrdiff_t i : {0, 1, 2, 5}) {
        if (i == 5 && !quad) break;
        outline.push_back(v[t[i]].pos);
        colours.push_back(v[t[i]].col);
    }
    add_mixture(reading.joining, outline, colours);
    return quad ? 6 : 3;
}

// Triangles of one colour that share vertices, which those of two shapes never do.
std::ptrdiff_t read_mesh(Reading& reading, const ImDrawIdx* begin, const ImDrawIdx* end,
                         const ImDrawVert* v) {
    std::vector<ImDrawIdx> mesh;
    ImU32 colour = 0;
    ImDrawIdx low = begin[0];
    ImDrawIdx high = begin[0];
    const ImDrawIdx* t = begin;
    for (; end - t >= 3 && one_texel(t, v); t += 3) {
        const auto shared = [&](ImDrawIdx i) { return i >= low && i <= high; };
        if (!std::any_of(t, t + 3, shared)) break;
        if (!invisible(t, v)) {
            if (!one_colour(t, v) || (!mesh.empty() && v[t[0]].col != colour)) break;
            colour = v[t[0]].col;
            mesh.insert(mesh.end(), t, t + 3);
        }
        low = std::min({low, t[0], t[1], t[2]});
        high = std::max({high, t[0], t[1], t[2]});
    }
    if (t == begin) return read_mixture(reading, begin, end, v);
    if (mesh.size() == 6 && is_quad(mesh.data())) {
        add_quad(reading.joining, {v[mesh[0]].pos, v[mesh[1]].pos, v[mesh[2]].pos, v[mesh[5]].pos},
                 colour);
        return t - begin;
    }
    if (!mesh.empty()) end_all(reading.joining);
    for (Outline& outline : outlines_of(mesh, v)) {
        add_polygon(reading.joining, std::move(outline), colour);
    }
    return t - begin;
}

void read_command(Reading& reading, const ImDrawList& list, const ImDrawCmd& command) {
    const ImDrawVert* v = list.VtxBuffer.Data + command.VtxOffset;
    const ImDrawIdx* t = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawIdx* const end = t + command.ElemCount;
    while (end - t >= 3) {
        t += one_texel(t, v) ? read_mesh(reading, t, end, v) : read_textured(reading, t, end, v);
    }
    end_all(reading.joining);
}

}  // namespace

std::vector<Shape> shapes_of(const ImDrawData& frame, const Fonts& fonts) {
    IM_ASSERT(frame.DisplayPos.x == 0.0F && frame.DisplayPos.y == 0.0F && "one picture, no offset");
    Reading reading{fonts, glyph_index(fonts)};
    const Rect whole = rect_at({0, 0}, frame.DisplaySize);
    for (int i = 0; i < frame.CmdListsCount; ++i) {
        const ImDrawList& list = *frame.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) continue;
            const ImVec4& c = command.ClipRect;
            reading.joining.clip = common({{c.x, c.y}, {c.z, c.w}}, whole);
            if (!reading.joining.clip.empty()) read_command(reading, list, command);
        }
    }
    return std::move(reading.joining.shapes);
}

}  // namespace tact
