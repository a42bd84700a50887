// The icon that a window shows is the one that desktops show.

#include "viz/picture/program_icon.h"

#include <doctest/doctest.h>

#include "viz/drawing/colour.h"

namespace program_icon_test {

using namespace tact;

TEST_CASE("icon: a dark plate with three points over a wave, nothing around it, at any size") {
    for (const int side : {16, 48, 128}) {
        CAPTURE(side);
        const Image icon = program_icon(side);
        REQUIRE(icon.rgba.size() == static_cast<std::size_t>(4 * side * side));
        const auto at = [&](int x, int y) { return pixel(icon, x * side / 128, y * side / 128); };
        CHECK((at(0, 0) >> IM_COL32_A_SHIFT) == 0);
        CHECK((at(127, 64) >> IM_COL32_A_SHIFT) == 0);
        CHECK(at(94, 46) == rgb(0x56B4E9));
        CHECK(at(60, 46) == rgb(0x14181D));
    }
    const Image large = program_icon(128);
    CHECK(pixel(large, 34, 38) == rgb(0xE69F00));
    CHECK(pixel(large, 66, 28) == rgb(0x009E73));
    CHECK(pixel(large, 55, 104) == rgb(0x56B4E9));
    CHECK(pixel(large, 64, 63) == rgb(0x56B4E9));
    CHECK(pixel(large, 18, 84) == rgb(0x56B4E9));
    CHECK(pixel(large, 14, 84) == rgb(0x14181D));
}

}  // namespace program_icon_test
