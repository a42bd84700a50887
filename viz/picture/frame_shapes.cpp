#include "viz/picture/frame_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viz/picture/mesh_outline.h"

namespace tact {
namespace {

constexpr float kTouchPx = 0.02F;  // ends of lines are computed from their corners

using Quad = std::array<ImVec2, 4>;

// A quad as a piece of a line.
struct Segment {
    ImVec2 from;
    ImVec2 to;
    float width_px = 0;
    bool upright = false;  // also a rectangle as ImGui writes them
    Quad corners{};
};

// What has been read so far, and what may still go on.
struct Reading {
    const Fonts& fonts;
    GlyphIndex glyphs;
    Rect clip{};
    std::vector<Shape> shapes{};
    std::vector<Segment> chain{};
    ImU32 chain_colour = 0;
    std::optional<TextRun> run{};
    ImU32 run_colour = 0;
};

bool opaque(ImU32 colour) { return (colour & IM_COL32_A_MASK) == IM_COL32_A_MASK; }
bool clear(ImU32 colour) { return (colour & IM_COL32_A_MASK) == 0; }

Rect bounds_of(const Outline& points, float margin_px) {
    Rect box{points.front(), points.front()};
    for (const ImVec2 p : points) box = around(box, {p, p});
    return inset(box, -margin_px);
}

bool same_clip(const std::optional<Rect>& a, const std::optional<Rect>& b) {
    if (!a || !b) return !a && !b;
    return same(a->min, b->min) && same(a->max, b->max);
}

// The last shape if it is of this form, colour and clip and another may be painted with it: what is
// not opaque is darker where it overlaps.
template <class T>
T* joinable(Reading& reading, ImU32 colour, const std::optional<Rect>& clip) {
    if (reading.shapes.empty() || !opaque(colour)) return nullptr;
    Shape& last = reading.shapes.back();
    if (last.colour != colour || !same_clip(last.clip, clip)) return nullptr;
    return std::get_if<T>(&last.form);
}

// The clip rectangle if it cuts something off; nothing is left where `box` is outside.
struct Clipping {
    bool nothing_left = false;
    std::optional<Rect> clip{};
};

Clipping clipping(const Rect& clip, const Rect& box, float slack_px = kTouchPx) {
    // Written so that a box of NaN counts as outside.
    const bool meets = box.min.x < clip.max.x && box.max.x > clip.min.x && box.min.y < clip.max.y &&
                       box.max.y > clip.min.y;
    if (!meets) return {true, std::nullopt};
    if (inset(clip, -slack_px).contains(box)) return {};
    return {false, clip};
}

// --- polygons

void add_polygon(Reading& reading, Outline outline, ImU32 colour) {
    const Clipping cut = clipping(reading.clip, bounds_of(outline, 0.0F));
    if (cut.nothing_left) return;
    make_clockwise(outline);
    if (auto* polygons = joinable<Polygons>(reading, colour, cut.clip)) {
        polygons->outlines.push_back(std::move(outline));
        return;
    }
    reading.shapes.push_back({Polygons{{std::move(outline)}}, colour, cut.clip});
}

// --- rectangles and lines

// ImGui makes a line's corners as from + n, to + n, to - n, from - n; n is to its left.
std::optional<Segment> segment_of(const Quad& q) {
    const ImVec2 along = q[1] - q[0];
    const ImVec2 side = q[3] - q[0];
    const float length = std::hypot(along.x, along.y);
    const float width = std::hypot(side.x, side.y);
    const ImVec2 fourth = q[1] + side - q[2];
    const float dot = along.x * side.x + along.y * side.y;
    const float turn = along.x * side.y - along.y * side.x;
    if (!(turn > 0.0F) || std::abs(dot) > 1e-3F * turn + 1e-6F ||
        std::abs(fourth.x) + std::abs(fourth.y) > kTouchPx) {
        return std::nullopt;
    }
    Segment segment{(q[0] + q[3]) * 0.5F, (q[1] + q[2]) * 0.5F, width, false, q};
    segment.upright = length > 0.0F && q[0].y == q[1].y && q[1].x == q[2].x && q[0].x < q[2].x;
    return segment;
}

bool touching(ImVec2 a, ImVec2 b) {
    return std::abs(a.x - b.x) <= kTouchPx && std::abs(a.y - b.y) <= kTouchPx;
}

void add_rect(Reading& reading, const Rect& rect, ImU32 colour) {
    const Rect kept = common(rect, reading.clip);
    if (!kept.empty()) reading.shapes.push_back({kept, colour, std::nullopt});
}

void add_polyline(Reading& reading, Polyline line, float width_px, ImU32 colour) {
    const Clipping cut = clipping(reading.clip, bounds_of(line.points, width_px / 2.0F));
    if (cut.nothing_left) return;
    auto* lines = joinable<Polylines>(reading, colour, cut.clip);
    if (lines != nullptr && std::abs(lines->width_px - width_px) <= kTouchPx) {
        lines->lines.push_back(std::move(line));
        return;
    }
    reading.shapes.push_back({Polylines{{std::move(line)}, width_px}, colour, cut.clip});
}

// A chain of touching quads is a rectangle while it runs level, and a line once it turns.
void end_chain(Reading& reading) {
    const std::vector<Segment> chain = std::exchange(reading.chain, {});
    if (chain.empty()) return;
    const Segment& first = chain.front();
    if (std::all_of(chain.begin(), chain.end(), [](const Segment& s) { return s.upright; })) {
        add_rect(reading, {first.corners[0], chain.back().corners[2]}, reading.chain_colour);
        return;
    }
    const ImVec2 along = first.to - first.from;
    if (chain.size() == 1 && std::hypot(along.x, along.y) < 1.5F * first.width_px) {
        add_polygon(reading, {first.corners.begin(), first.corners.end()}, reading.chain_colour);
        return;
    }
    Polyline line;
    line.points.push_back(first.from);
    for (const Segment& s : chain) line.points.push_back(s.to);
    line.closed = chain.size() > 2 && touching(first.from, chain.back().to);
    if (line.closed) line.points.pop_back();
    add_polyline(reading, std::move(line), first.width_px, reading.chain_colour);
}

// --- text

// A halo is made of copies around the text, in a colour of their own.
void absorb_halo(const std::vector<Shape>& shapes, TextRun& run, std::size_t& copies) {
    copies = 0;
    float farthest = 0.0F;
    while (copies < shapes.size()) {
        const Shape& shape = shapes[shapes.size() - 1 - copies];
        const auto* copy = std::get_if<TextRun>(&shape.form);
        if (copy == nullptr || copy->halo_px > 0.0F || shape.colour != shapes.back().colour) break;
        const std::optional<float> offset = offset_of_copy(run, *copy);
        if (!offset || *offset > 0.3F * run.size_px) break;
        farthest = std::max(farthest, *offset);
        ++copies;
    }
    if (copies < 4) {
        copies = 0;
        return;
    }
    run.halo = shapes.back().colour;
    run.halo_px = farthest;
}

void end_run(Reading& reading) {
    if (!reading.run) return;
    TextRun run = *std::exchange(reading.run, std::nullopt);
    // Edges of glyphs may pass the clip rectangle by less than shows.
    Clipping cut = clipping(reading.clip, run.box, 0.5F);
    if (cut.nothing_left) return;
    if (run.kept) cut.clip = common(reading.clip, *run.kept);
    std::size_t copies = 0;
    absorb_halo(reading.shapes, run, copies);
    reading.shapes.resize(reading.shapes.size() - copies);
    reading.shapes.push_back({std::move(run), reading.run_colour, cut.clip});
}

void end_all(Reading& reading) {
    end_chain(reading);
    end_run(reading);
}

void read_glyph(Reading& reading, const DrawnGlyph& glyph, ImU32 colour) {
    if (reading.run && reading.run_colour == colour && extend(*reading.run, glyph)) return;
    end_all(reading);
    reading.run = run_of(glyph);
    reading.run_colour = colour;
}

// --- triangles

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
        end_all(reading);
        const auto baked_px = static_cast<float>(kDiscRadiiPx[i]);
        const float half = (quad[2].pos.x - quad[0].pos.x) / 2.0F;
        const Circle circle{(quad[0].pos + quad[2].pos) * 0.5F,
                            half * baked_px / (baked_px + 1.0F)};
        const Rect box = bounds_of({circle.centre}, circle.radius_px);
        const Clipping cut = clipping(reading.clip, box);
        if (!cut.nothing_left) reading.shapes.push_back({circle, colour, cut.clip});
        return 6;
    }
    if (const auto glyph = glyph_of(reading.glyphs, quad)) read_glyph(reading, *glyph, colour);
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
void add_mixture(Reading& reading, const Outline& outline, const std::vector<ImU32>& colours) {
    end_all(reading);
    const Clipping cut = clipping(reading.clip, bounds_of(outline, 0.0F));
    if (cut.nothing_left) return;
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const std::size_t k = (i + 2) % n;
        const std::size_t l = (i + 3) % n;  // in a triangle: i again
        if (colours[i] != colours[j] || (n == 4 && colours[k] != colours[l])) continue;
        const ImVec2 from = (outline[i] + outline[j]) * 0.5F;
        ImVec2 to = n == 4 ? (outline[k] + outline[l]) * 0.5F : outline[k];
        // Colour is constant along the first side: go on at a right angle to it.
        const ImVec2 side = outline[j] - outline[i];
        const float square = std::max(side.x * side.x + side.y * side.y, 1e-12F);
        const ImVec2 way = to - from;
        to = to - side * ((way.x * side.x + way.y * side.y) / square);
        reading.shapes.push_back(
            {GradientPolygon{outline, from, to, colours[k]}, colours[i], cut.clip});
        return;
    }
    reading.shapes.push_back({Polygons{{outline}}, mean_colour(colours), cut.clip});
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
    add_mixture(reading, outline, colours);
    return quad ? 6 : 3;
}

void read_quad(Reading& reading, const Quad& quad, ImU32 colour) {
    const std::optional<Segment> segment = segment_of(quad);
    if (!segment) {
        if (touching(quad[0], quad[1]) && touching(quad[0], quad[2]))
            return;  // a line of no length
        end_all(reading);
        add_polygon(reading, {quad.begin(), quad.end()}, colour);
        return;
    }
    const bool goes_on = !reading.chain.empty() && reading.chain_colour == colour &&
                         touching(reading.chain.back().to, segment->from) &&
                         std::abs(reading.chain.back().width_px - segment->width_px) <= kTouchPx;
    if (!goes_on) end_all(reading);
    reading.chain.push_back(*segment);
    reading.chain_colour = colour;
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
        read_quad(reading, {v[mesh[0]].pos, v[mesh[1]].pos, v[mesh[2]].pos, v[mesh[5]].pos},
                  colour);
        return t - begin;
    }
    if (!mesh.empty()) end_all(reading);
    for (Outline& outline : outlines_of(mesh, v)) {
        add_polygon(reading, std::move(outline), colour);
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
    end_all(reading);
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
            reading.clip = common({{c.x, c.y}, {c.z, c.w}}, whole);
            if (!reading.clip.empty()) read_command(reading, list, command);
        }
    }
    return std::move(reading.shapes);
}

}  // namespace tact
