#include "viz/picture/shape_joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "viz/drawing/geometry.h"

namespace tact {

namespace {

constexpr float kTouchPx = 0.02F;  // ends of lines are computed from their corners

bool opaque(ImU32 colour) { return (colour & IM_COL32_A_MASK) == IM_COL32_A_MASK; }

bool same_clip(const std::optional<Rect>& a, const std::optional<Rect>& b) {
    if (!a || !b) return !a && !b;
    return same(a->min, b->min) && same(a->max, b->max);
}

// The last shape if it is of this form, colour and clip and another may be painted with it: what is
// not opaque is darker where it overlaps.
template <class T>
T* joinable(ShapeJoining& joining, ImU32 colour, const std::optional<Rect>& clip) {
    if (joining.shapes.empty() || !opaque(colour)) return nullptr;
    Shape& last = joining.shapes.back();
    if (last.colour != colour || !same_clip(last.clip, clip)) return nullptr;
    return std::get_if<T>(&last.form);
}

Clipping clipping_within(const Rect& clip, const Rect& box, float slack_px) {
    // Written so that a box of NaN counts as outside.
    const bool meets = box.min.x < clip.max.x && box.max.x > clip.min.x && box.min.y < clip.max.y &&
                       box.max.y > clip.min.y;
    if (!meets) return {true, std::nullopt};
    if (inset(clip, -slack_px).contains(box)) return {};
    return {false, clip};
}

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

void add_rect(ShapeJoining& joining, const Rect& rect, ImU32 colour) {
    const Rect kept = common(rect, joining.clip);
    if (!kept.empty()) joining.shapes.push_back({kept, colour, std::nullopt});
}

void add_polyline(ShapeJoining& joining, Polyline line, float width_px, ImU32 colour) {
    const Clipping cut = clipping(joining.clip, bounds_of(line.points, width_px / 2.0F));
    if (cut.nothing_left) return;
    auto* lines = joinable<Polylines>(joining, colour, cut.clip);
    if (lines != nullptr && std::abs(lines->width_px - width_px) <= kTouchPx) {
        lines->lines.push_back(std::move(line));
        return;
    }
    joining.shapes.push_back({Polylines{{std::move(line)}, width_px}, colour, cut.clip});
}

// A chain of touching quads is a rectangle while it runs level, and a line once it turns.
void end_chain(ShapeJoining& joining) {
    const std::vector<Segment> chain = std::exchange(joining.chain, {});
    if (chain.empty()) return;
    const Segment& first = chain.front();
    if (std::all_of(chain.begin(), chain.end(), [](const Segment& s) { return s.upright; })) {
        add_rect(joining, {first.corners[0], chain.back().corners[2]}, joining.chain_colour);
        return;
    }
    const ImVec2 along = first.to - first.from;
    if (chain.size() == 1 && std::hypot(along.x, along.y) < 1.5F * first.width_px) {
        add_polygon(joining, {first.corners.begin(), first.corners.end()}, joining.chain_colour);
        return;
    }
    Polyline line;
    line.points.push_back(first.from);
    for (const Segment& s : chain) line.points.push_back(s.to);
    line.closed = chain.size() > 2 && touching(first.from, chain.back().to);
    if (line.closed) line.points.pop_back();
    add_polyline(joining, std::move(line), first.width_px, joining.chain_colour);
}

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

void end_run(ShapeJoining& joining) {
    if (!joining.run) return;
    TextRun run = *std::exchange(joining.run, std::nullopt);
    // Edges of glyphs may pass the clip rectangle by less than shows.
    Clipping cut = clipping_within(joining.clip, run.box, 0.5F);
    if (cut.nothing_left) return;
    if (run.kept) cut.clip = common(joining.clip, *run.kept);
    std::size_t copies = 0;
    absorb_halo(joining.shapes, run, copies);
    joining.shapes.resize(joining.shapes.size() - copies);
    joining.shapes.push_back({std::move(run), joining.run_colour, cut.clip});
}

}  // namespace

Rect bounds_of(const Outline& points, float margin_px) {
    Rect box{points.front(), points.front()};
    for (const ImVec2 p : points) box = around(box, {p, p});
    return inset(box, -margin_px);
}

Clipping clipping(const Rect& clip, const Rect& box) {
    return clipping_within(clip, box, kTouchPx);
}

void add_polygon(ShapeJoining& joining, Outline outline, ImU32 colour) {
    const Clipping cut = clipping(joining.clip, bounds_of(outline, 0.0F));
    if (cut.nothing_left) return;
    make_clockwise(outline);
    if (auto* polygons = joinable<Polygons>(joining, colour, cut.clip)) {
        polygons->outlines.push_back(std::move(outline));
        return;
    }
    joining.shapes.push_back({Polygons{{std::move(outline)}}, colour, cut.clip});
}

void add_circle(ShapeJoining& joining, const Circle& circle, ImU32 colour) {
    const Rect box = bounds_of({circle.centre}, circle.radius_px);
    const Clipping cut = clipping(joining.clip, box);
    if (!cut.nothing_left) joining.shapes.push_back({circle, colour, cut.clip});
}

void add_quad(ShapeJoining& joining, const Quad& quad, ImU32 colour) {
    const std::optional<Segment> segment = segment_of(quad);
    if (!segment) {
        if (touching(quad[0], quad[1]) && touching(quad[0], quad[2]))
            return;  // a line of no length
        end_all(joining);
        add_polygon(joining, {quad.begin(), quad.end()}, colour);
        return;
    }
    const bool goes_on = !joining.chain.empty() && joining.chain_colour == colour &&
                         touching(joining.chain.back().to, segment->from) &&
                         std::abs(joining.chain.back().width_px - segment->width_px) <= kTouchPx;
    if (!goes_on) end_all(joining);
    joining.chain.push_back(*segment);
    joining.chain_colour = colour;
}

void add_glyph(ShapeJoining& joining, const DrawnGlyph& glyph, ImU32 colour) {
    if (joining.run && joining.run_colour == colour && extend(*joining.run, glyph)) return;
    end_all(joining);
    joining.run = run_of(glyph);
    joining.run_colour = colour;
}

void end_all(ShapeJoining& joining) {
    end_chain(joining);
    end_run(joining);
}

std::vector<Outline> outlines_of(const std::vector<ImDrawIdx>& triangles, const ImDrawVert* v) {
    using Edge = std::pair<ImDrawIdx, ImDrawIdx>;
    std::vector<Edge> edges;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const std::array<ImDrawIdx, 3> t{triangles[i], triangles[i + 1], triangles[i + 2]};
        for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(t[k], t[(k + 1) % 3]);
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> rim;
    for (const Edge& e : edges) {
        const bool inner = std::binary_search(edges.begin(), edges.end(), Edge{e.second, e.first});
        if (!inner && e.first != e.second) rim.push_back(e);
    }
    std::vector<bool> used(rim.size(), false);
    const auto next_from = [&](ImDrawIdx vertex) {
        auto at = std::lower_bound(rim.begin(), rim.end(), Edge{vertex, 0});
        while (at != rim.end() && at->first == vertex &&
               used[static_cast<std::size_t>(at - rim.begin())]) {
            ++at;
        }
        return at != rim.end() && at->first == vertex ? at - rim.begin() : -1;
    };
    std::vector<Outline> outlines;
    for (std::size_t start = 0; start < rim.size(); ++start) {
        if (used[start]) continue;
        Outline outline;
        for (auto at = static_cast<std::ptrdiff_t>(start); at >= 0;
             at = next_from(rim[static_cast<std::size_t>(at)].second)) {
            used[static_cast<std::size_t>(at)] = true;
            const ImVec2 p = v[rim[static_cast<std::size_t>(at)].first].pos;
            if (outline.empty() || !same(outline.back(), p)) outline.push_back(p);
        }
        if (outline.size() >= 3) outlines.push_back(std::move(outline));
    }
    return outlines;
}

void make_clockwise(Outline& outline) {
    double twice_area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const ImVec2 a = outline[i];
        const ImVec2 b = outline[(i + 1) % outline.size()];
        twice_area += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    if (twice_area < 0.0) std::reverse(outline.begin(), outline.end());
}

}  // namespace tact
