#include "viz/drawing/marks.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/presence.h"
#include "viz/picture/picture.h"

namespace tact::marks_test {

TEST_CASE("marks: the four receptor shapes cover equal areas") {
    for (const Receptor receptor : kReceptors) {
        ImU32 colour = 0;
        const Image image = draw_picture(80, 80, {}, [&](const Theme& theme) {
            colour = theme.receptor[index_of(receptor)];
            draw_receptor_mark(*ImGui::GetWindowDrawList(), theme, {40, 40}, 20.0F, receptor);
        });
        // A soft edge of one pixel around a circumference of 130 px takes some of them.
        const double area = std::numbers::pi * 20.0 * 20.0;
        CHECK(std::abs(count_pixels(image, whole(image), colour, 60) - area) <= 0.08 * area);
    }
}

TEST_CASE("marks: a disc from the font texture is as large as it says, at any radius") {
    for (const float radius : {3.0F, 6.5F, 12.0F, 31.0F, 45.0F}) {
        ImU32 ink = 0;
        const Image image = draw_picture(120, 120, {}, [&](const Theme& theme) {
            ink = theme.text;
            draw_disc(*ImGui::GetWindowDrawList(), theme, {60, 60}, radius, theme.text);
        });
        const double area = std::numbers::pi * static_cast<double>(radius * radius);
        // Pixels at least half covered, give or take half a pixel of radius.
        CHECK(std::abs(count_pixels(image, whole(image), ink, 110) - area) <=
              std::numbers::pi * static_cast<double>(radius));
    }
}

TEST_CASE("marks: shortened text fits, ends in an ellipsis and keeps whole characters") {
    draw_picture(10, 10, {}, [](const Theme& theme) {
        const ImFont* font = theme.fonts.regular;
        CHECK(shortened(font, "short", 500.0F) == "short");
        const std::string cut = shortened(font, "ééééééééééééééé", 60.0F);
        CHECK(text_size(font, cut).x <= 60.0F);
        CHECK(cut.ends_with("…"));
        CHECK(cut.substr(0, 2) == "é");
        CHECK(cut.size() % 2 == std::string{"…"}.size() % 2);  // no half of a two-byte letter
    });
}

TEST_CASE("marks: stale content stays recognisable at about 45 %") {
    const Image image = draw_picture(100, 100, {}, [](const Theme& theme) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({0, 0}, {100, 100}, IM_COL32_WHITE);
        draw_stale(list, theme, {{0, 0}, {100, 100}}, 0.0);
    });
    const Theme theme = dark_theme(1.0F);
    const int pane = static_cast<int>(theme.pane & 0xFFU);
    const int veiled = static_cast<int>(std::lround(pane + 0.45 * (255 - pane)));
    const auto grey = static_cast<unsigned>(veiled);
    CHECK(count_pixels(image, whole(image), IM_COL32(grey, grey, grey, 255), 8) > 5000);
    CHECK(count_pixels(image, whole(image), IM_COL32_WHITE, 8) == 0);
}

TEST_CASE("marks: a read-out stays inside its bounds in every corner") {
    for (const ImVec2 at : {ImVec2{1, 1}, {298, 1}, {1, 148}, {298, 148}}) {
        const Rect bounds{{20, 20}, {280, 130}};
        const Image image = draw_picture(300, 150, {}, [&](const Theme& theme) {
            const std::array<std::string, 2> lines{"0.691 g", "0.422 s"};
            draw_readout(*ImGui::GetWindowDrawList(), theme, bounds, at, lines);
        });
        const ImU32 pane = dark_theme(1.0F).pane;
        const int outside = 300 * 150 - 260 * 110;
        const int changed = 300 * 150 - count_pixels(image, whole(image), pane);
        CHECK(changed > 500);
        CHECK(count_pixels(image, whole(image), pane) - count_pixels(image, bounds, pane) ==
              outside);
    }
}

}  // namespace tact::marks_test
