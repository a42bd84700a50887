#include "viz/drawing/colour.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace tact::colormap_test {
namespace {

int largest_difference(ImU32 a, ImU32 b) {
    int largest = 0;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        const int delta =
            static_cast<int>((a >> shift) & 0xFFU) - static_cast<int>((b >> shift) & 0xFFU);
        largest = std::max(largest, std::abs(delta));
    }
    return largest;
}

}  // namespace

TEST_CASE("colour map: every mark stands out from the pane it is on, dark or light") {
    for (const ImU32 ground : {rgb(0x1B1F24), rgb(0xFFFFFF), rgb(0x000000)}) {
        const MarkColours colours = mark_colours(ground);
        for (double t = 0.0; t <= 1.0; t += 0.01) CHECK(contrast(colours(t), ground) >= 3.0);
        CHECK(colours.to - colours.from > 0.5);  // and they tell numbers apart
        CHECK(colours(std::nan("")) == colours(0.0));
    }
}

// Entries of matplotlib's own table: [matplotlib.colors.to_hex(viridis(i / 8)) for i in range(9)].
TEST_CASE("colour map: viridis is the published one to 4 of 255") {
    constexpr std::array<std::uint32_t, 9> kPublished{
        0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725};
    for (std::size_t i = 0; i < kPublished.size(); ++i) {
        CHECK(largest_difference(viridis(static_cast<double>(i) / 8.0), rgb(kPublished[i])) <= 4);
    }
}

TEST_CASE("colour map: larger values are lighter in viridis and cividis, so grey prints work") {
    // One step of 1/255 in green, which rounding may take back, is up to 0.006 of luminance.
    for (int i = 8; i < 256; ++i) {
        CHECK(luminance(viridis(i / 255.0)) >= luminance(viridis((i - 8) / 255.0)));
        CHECK(luminance(cividis(i / 255.0)) >= luminance(cividis((i - 8) / 255.0)));
        CHECK(luminance(viridis(i / 255.0)) >= luminance(viridis((i - 1) / 255.0)) - 0.006);
    }
}

TEST_CASE("colour map: differences are white at zero, blue below and orange above") {
    CHECK(luminance(diverging(0.0)) > 0.9);
    CHECK(diverging(-1.0) == rgb(0x0072B2));
    CHECK(diverging(1.0) == rgb(0xD55E00));
}

TEST_CASE("colour map: values outside the range take the colour of its end, NaN of the lowest") {
    CHECK(viridis(-3.0) == viridis(0.0));
    CHECK(viridis(7.0) == viridis(1.0));
    CHECK(viridis(std::nan("")) == viridis(0.0));
    CHECK(diverging(std::nan("")) == diverging(0.0));
}

}  // namespace tact::colormap_test
