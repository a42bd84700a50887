// Text in SVG: where it stands, how large, in how many elements.
#include "viz/picture/svg.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/drawn_svg.h"
#include "tests/support/svg_elements.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/picture/picture.h"

namespace tact::svg_text_test {

TEST_CASE("svg: text is one element with its words and spaces, whatever signs it has") {
    const std::string words = "a <b> & \"c\" \u2013 12.5 \u00B5m";
    const std::string svg = drawn_svg([&](ImDrawList& list, const Theme& theme) {
        draw_text(list, theme.fonts.semibold, {10, 20}, rgb(0x123456), words);
    });
    const auto texts = elements_of(svg, "text");
    REQUIRE(texts.size() == 1);
    CHECK(texts[0].text == words);
    CHECK(texts[0].value("fill") == "#123456");
    CHECK(texts[0].value("font-weight") == "600");
    CHECK(std::stod(texts[0].value("x")) == 10.0);
    const auto places = texts[0].value("x");
    CHECK(std::ranges::count(places, ' ') == 21 - 1);  // 21 characters
}

TEST_CASE("svg: letters are as large and stand as high as in the pixels") {
    // The cap height of Inter is 0.727 em; H stands on the baseline.
    float top = 0.0F;
    float bottom = 0.0F;
    const auto draw = [](const Theme& theme) {
        draw_text(*ImGui::GetWindowDrawList(), theme.fonts.large, {40, 30}, theme.text, "H");
    };
    const PictureOptions large{.scale = 4.0F};
    const Image image = draw_picture(200, 150, large, draw);
    const ImU32 ground = pixel(image, 0, 0);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (pixel(image, x, y) == ground) continue;
            if (top == 0.0F) top = static_cast<float>(y);
            bottom = static_cast<float>(y) + 1.0F;
        }
    }
    const auto texts = elements_of(draw_svg(200, 150, large, draw), "text");
    REQUIRE(texts.size() == 1);
    CHECK(std::abs(texts[0].number("y") - bottom) <= 1.0);  // hinting snaps to a pixel
    const double cap_px = 0.727 * texts[0].number("font-size");
    CHECK(std::abs(cap_px - (bottom - top)) <= 1.5);
}

TEST_CASE("svg: two texts beside each other stay two, also on one line") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme& theme) {
        draw_text(list, theme.fonts.small, {10, 20}, theme.text, "12.5");
        draw_text(list, theme.fonts.small, {60, 20}, theme.text, "12.5");
        draw_text(list, theme.fonts.small, {10, 40}, theme.text, "ab");
        draw_text(list, theme.fonts.small, {10, 60}, theme.text, "c");
        draw_text(list, theme.fonts.small, {16, 60}, theme.accent, "d");
    });
    CHECK(elements_of(svg, "text").size() == 5);
    CHECK(text_count(svg, "12.5") == 2);
}

TEST_CASE("svg: a halo is the stroke of its text, not four more texts") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme& theme) {
        draw_text_halo(list, theme.fonts.small, {30, 20}, rgb(0xFFFFFF), rgb(0x203040), 2.0F,
                       "L-0-half");
        draw_text_halo(list, theme.fonts.small, {30, 50}, rgb(0xFFFFFF), rgb(0x203040), 1.0F, "L");
    });
    const auto texts = elements_of(svg, "text");
    REQUIRE(texts.size() == 2);
    CHECK(texts[0].text == "L-0-half");
    CHECK(texts[0].value("fill") == "#ffffff");
    CHECK(texts[0].value("stroke") == "#203040");
    CHECK(texts[0].number("stroke-width") == 4.0);
    CHECK(texts[0].value("paint-order") == "stroke");
    CHECK(texts[1].text == "L");
    CHECK(texts[1].number("stroke-width") == 2.0);
}

TEST_CASE("svg: text that reads upwards is turned to the left around its own place") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme& theme) {
        draw_text_upwards(list, theme.fonts.small, {50, 90}, theme.text, "up and on");
    });
    const auto texts = elements_of(svg, "text");
    REQUIRE(texts.size() == 1);
    CHECK(texts[0].text == "up and on");
    CHECK(texts[0].value("transform") == "rotate(-90)");
    // Turned back, x runs up the screen from its lower edge and y to the right.
    CHECK(std::stod(texts[0].value("x")) == -90.0);
    CHECK(texts[0].number("y") > 50.0);
    CHECK(texts[0].number("y") < 65.0);
}

TEST_CASE("svg: text that a widget cuts off ends where it does there") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme& theme) {
        const ImVec4 fine{0, 0, 50, 100};
        const std::string_view text = "a long hint";
        list.AddText(theme.fonts.regular, theme.fonts.regular->FontSize, {10, 20}, theme.text,
                     text.data(), text.data() + text.size(), 0.0F, &fine);
    });
    const auto texts = elements_of(svg, "text");
    REQUIRE(texts.size() == 1);
    CHECK(std::string_view("a long hint").starts_with(texts[0].text));
    CHECK(std::stod(texts[0].value("x")) == 10.0);
    const auto all = elements_of(svg);
    const auto clip = std::ranges::find(all, "clipPath", &SvgElement::name);
    REQUIRE(clip != all.end());
    const SvgElement& rect = *(clip + 1);
    CHECK(rect.number("x") + rect.number("width") == 50.0);
}

}  // namespace tact::svg_text_test
