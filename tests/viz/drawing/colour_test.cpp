#include "viz/drawing/colour.h"

#include <doctest/doctest.h>

#include <cmath>

namespace tact::colour_test {

TEST_CASE("colour: black on white has the contrast 21 that WCAG gives") {
    CHECK(std::abs(contrast(IM_COL32_BLACK, IM_COL32_WHITE) - 21.0) <= 1e-9);
    CHECK(std::abs(contrast(rgb(0x777777), IM_COL32_WHITE) - 4.48) <= 0.01);  // known from WCAG
}

TEST_CASE("colour: a mixture starts at one colour and ends at the other") {
    const ImU32 a = rgb(0x102030);
    const ImU32 b = rgb(0xF0E0D0);
    CHECK(mixed(a, b, 0.0F) == a);
    CHECK(mixed(a, b, 1.0F) == b);
    CHECK(mixed(a, b, 0.5F) == rgb(0x808080));
}

TEST_CASE("colour: only six hexadecimal digits after # are a colour") {
    CHECK(parse_colour("#56B4E9") == rgb(0x56B4E9));
    for (const char* text : {"", "#", "56B4E9", "#56B4E", "#56B4E9F", "#56B4EG", "#-6B4E9"}) {
        CHECK_FALSE(parse_colour(text).has_value());
    }
}

TEST_CASE("colour: fading changes the opacity only") {
    CHECK(faded(rgb(0x123456), 0.5F) == ((rgb(0x123456) & ~IM_COL32_A_MASK) | (128U << 24U)));
}

TEST_CASE("colour: text on any ground is readable") {
    for (std::uint32_t grey = 0; grey < 256; ++grey) {
        const ImU32 ground = rgb(grey * 0x010101);
        CHECK(contrast(ground, readable_on(ground)) >= 4.5);
    }
}

}  // namespace tact::colour_test
