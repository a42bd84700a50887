#include "viz/picture/changed_area.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace tact {

const std::uint8_t* bytes_at(const Image& image, int x, int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                    static_cast<std::size_t>(x);
    return image.rgba.data() + 4 * at;
}

bool is_same_pixel(const Image& a, const Image& b, int x, int y) {
    return std::memcmp(bytes_at(a, x, y), bytes_at(b, x, y), 4) == 0;
}

ChangedArea changed_area(const Image& before, const Image& after) {
    assert(before.width == after.width && before.height == after.height);
    int left = after.width;
    int right = -1;
    int top = after.height;
    int bottom = -1;
    for (int y = 0; y < after.height; ++y) {
        for (int x = 0; x < after.width; ++x) {
            if (is_same_pixel(before, after, x, y)) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = y;
        }
    }
    if (right < 0) return {};
    return {left, top, right - left + 1, bottom - top + 1};
}

}  // namespace tact
