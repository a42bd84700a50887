// Points and rectangles on the screen, in pixels, y downwards.
#pragma once

#include <imgui.h>

#include <algorithm>

namespace tact {

inline ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }
inline ImVec2 operator-(ImVec2 a, ImVec2 b) { return {a.x - b.x, a.y - b.y}; }
inline ImVec2 operator*(ImVec2 a, float factor) { return {a.x * factor, a.y * factor}; }
inline bool same(ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; }

struct Rect {
    ImVec2 min{0, 0};
    ImVec2 max{0, 0};

    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
    ImVec2 size() const { return max - min; }
    ImVec2 centre() const { return (min + max) * 0.5F; }
    bool empty() const { return width() <= 0.0F || height() <= 0.0F; }
    bool contains(ImVec2 p) const {
        return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y;
    }
    bool contains(const Rect& r) const {
        return r.min.x >= min.x && r.max.x <= max.x && r.min.y >= min.y && r.max.y <= max.y;
    }
    bool intersects(const Rect& r) const {
        return r.min.x < max.x && r.max.x > min.x && r.min.y < max.y && r.max.y > min.y;
    }
};

inline Rect rect_at(ImVec2 corner, ImVec2 size) { return {corner, corner + size}; }

// The rectangle made smaller by a margin on every side; negative: larger.
inline Rect inset(const Rect& r, float margin) {
    return {{r.min.x + margin, r.min.y + margin}, {r.max.x - margin, r.max.y - margin}};
}

// What two rectangles share; without extent or less where they do not meet.
inline Rect common(const Rect& a, const Rect& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

// The smallest rectangle around two.
inline Rect around(const Rect& a, const Rect& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

// `inner` moved by the least that brings it into `outer` (top left wins if it is too large).
inline Rect moved_into(Rect inner, const Rect& outer) {
    const ImVec2 size = inner.size();
    inner.min.x = std::max(outer.min.x, std::min(inner.min.x, outer.max.x - size.x));
    inner.min.y = std::max(outer.min.y, std::min(inner.min.y, outer.max.y - size.y));
    return rect_at(inner.min, size);
}

// Distance from a point to the nearest point of a rectangle, squared; 0 inside.
inline float squared_distance(const Rect& r, ImVec2 p) {
    const float dx = std::max({r.min.x - p.x, 0.0F, p.x - r.max.x});
    const float dy = std::max({r.min.y - p.y, 0.0F, p.y - r.max.y});
    return dx * dx + dy * dy;
}

}  // namespace tact
