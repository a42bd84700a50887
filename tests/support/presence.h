// Counting pixels in pictures of views: is what should be there there?
#pragma once

#include <cstdlib>

#include "viz/drawing/geometry.h"
#include "viz/picture/picture.h"

namespace tact {

// Pixels inside `area` within `tolerance` (of 255, each component) of a colour.
inline int count_pixels(const Image& image, const Rect& area, ImU32 colour, int tolerance = 0) {
    const auto close = [&](ImU32 a) {
        for (unsigned shift = 0; shift < 24; shift += 8) {
            const int delta = static_cast<int>((a >> shift) & 0xFFU) -
                              static_cast<int>((colour >> shift) & 0xFFU);
            if (std::abs(delta) > tolerance) return false;
        }
        return true;
    };
    int count = 0;
    for (int y = static_cast<int>(area.min.y); y < static_cast<int>(area.max.y); ++y) {
        for (int x = static_cast<int>(area.min.x); x < static_cast<int>(area.max.x); ++x) {
            if (close(pixel(image, x, y))) ++count;
        }
    }
    return count;
}

// Pixels beyond `area` that are not of the ground's colour: what was drawn where it should not be.
inline int count_strays(const Image& image, const Rect& area, ImU32 ground) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const ImVec2 middle{static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F};
            if (!area.contains(middle) && pixel(image, x, y) != ground) ++count;
        }
    }
    return count;
}

inline Rect whole(const Image& image) {
    return {{0, 0}, {static_cast<float>(image.width), static_cast<float>(image.height)}};
}

}  // namespace tact
