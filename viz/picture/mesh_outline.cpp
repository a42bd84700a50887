#include "viz/picture/mesh_outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "viz/drawing/geometry.h"

namespace tact {

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
