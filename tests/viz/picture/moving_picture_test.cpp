// Moving pictures: what is painted again, which colours stand for many, and what the files hold.
// Whole films are read by another program in tests/e2e/film.
#include <doctest/doctest.h>

#include <algorithm>

#include "viz/picture/apng.h"
#include "viz/picture/frame_damage.h"
#include "viz/picture/gif.h"

namespace moving_picture_test {

using namespace tact;

namespace {

void paint(Image& image, int x, int y, ImU32 colour) {
    const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x));
    for (std::size_t k = 0; k < 4; ++k) {
        image.rgba[at + k] = static_cast<std::uint8_t>(colour >> (8 * k) & 0xFFU);
    }
}

int count_of(const std::string& bytes, const std::string& word) {
    int count = 0;
    for (std::size_t at = bytes.find(word); at != std::string::npos; at = bytes.find(word, at + 1))
        ++count;
    return count;
}

}  // namespace

TEST_CASE("changed area: from the first to the last pixel that differs, one pixel of none") {
    const Image before = blank_image(20, 10, IM_COL32(1, 2, 3, 255));
    Image after = before;
    ChangedArea none = changed_area(before, after);
    CHECK((none.width == 1 && none.height == 1));
    paint(after, 4, 7, IM_COL32_WHITE);
    paint(after, 9, 3, IM_COL32_WHITE);
    const ChangedArea area = changed_area(before, after);
    CHECK((area.x == 4 && area.y == 3 && area.width == 6 && area.height == 5));
}

TEST_CASE("palette: few colours stay as they are, many lose little") {
    std::vector<Rgb> few;
    for (int k = 0; k < 200; ++k) few.push_back({static_cast<std::uint8_t>(k), 7, 9});
    Palette exact = palette_of(few, 255);
    for (const Rgb& c : few) CHECK(exact.colours[nearest_colour(exact, c)] == c);
    std::vector<Rgb> many;
    for (int r = 0; r < 256; r += 8) {
        for (int g = 0; g < 256; g += 8) {
            for (int b = 0; b < 256; b += 32) {
                many.push_back({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                                static_cast<std::uint8_t>(b)});
            }
        }
    }
    Palette palette = palette_of(many, 255);
    CHECK(palette.colours.size() == 255);
    int worst = 0;
    for (const Rgb& c : many) {
        const Rgb& stand_in = palette.colours[nearest_colour(palette, c)];
        worst = std::max({worst, std::abs(c.r - stand_in.r), std::abs(c.g - stand_in.g),
                          std::abs(c.b - stand_in.b)});
    }
    CHECK(worst <= 40);  // 255 cells of a cube of 256: a side of 40
}

TEST_CASE("moving pictures: as many frames as were added, the same bytes each time") {
    const auto film = [] {
        ApngWriter apng;
        GifWriter gif(0.04);
        Image image = blank_image(16, 16, IM_COL32(0, 0, 0, 255));
        for (int k = 0; k < 5; ++k) {
            paint(image, k, k, IM_COL32_WHITE);
            add_frame(apng, image);
            REQUIRE(add_frame(gif, image));
        }
        const auto bytes = finished(gif);
        REQUIRE(bytes);
        return std::pair{finished(apng), *bytes};
    };
    const auto [apng, gif] = film();
    CHECK(apng.starts_with("\x89PNG\r\n\x1a\n"));
    CHECK(count_of(apng, "fcTL") == 5);
    CHECK(count_of(apng, "IDAT") == 1);
    CHECK(count_of(apng, "fdAT") == 4);
    CHECK(apng.ends_with(std::string("IEND\xae\x42\x60\x82", 8)));
    CHECK(gif.starts_with("GIF89a"));
    CHECK(count_of(gif, "NETSCAPE2.0") == 1);
    CHECK(gif.back() == ';');
    CHECK(film() == std::pair{apng, gif});
}

TEST_CASE("moving pictures: a picture that stays the same costs next to nothing") {
    ApngWriter apng;
    const Image image = blank_image(640, 360, IM_COL32(30, 60, 90, 255));
    add_frame(apng, image);
    const std::size_t one = apng.bytes.size();
    add_frame(apng, image);
    CHECK(apng.bytes.size() - one < 120);
}

}  // namespace moving_picture_test
