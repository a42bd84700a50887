#include "app/pictures.h"

#include <doctest/doctest.h>

#include <set>

#include "presence.h"
#include "viz/theme.h"

using namespace tact;

namespace {

PatternSet three_patterns() {
    PatternSet set;
    for (const double frequency_hz : {60.0, 150.0, 250.0}) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.carriers[0].frequency_hz = frequency_hz;
        Vibration vibration;
        vibration.name = std::to_string(static_cast<int>(frequency_hz)) + " Hz";
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

std::size_t colours_in(const Image& image, const Rect& area) {
    std::set<ImU32> colours;
    for (int y = static_cast<int>(area.min.y); y < static_cast<int>(area.max.y); y += 2) {
        for (int x = static_cast<int>(area.min.x); x < static_cast<int>(area.max.x); x += 2) {
            colours.insert(pixel(image, x, y));
        }
    }
    return colours.size();
}

}  // namespace

TEST_CASE("pictures: the window has five panes, none of them blank") {
    PictureSize size;
    size.width = 1600;
    size.height = 1000;
    for (const bool dark : {true, false}) {
        size.dark = dark;
        const Image image = std::get<Image>(window_picture(three_patterns(), 1, size));
        REQUIRE(image.width == 1600);
        REQUIRE(image.height == 1000);
        const Theme theme = dark ? dark_theme(1.0F) : light_theme(1.0F);
        const Rect patterns{{10.0F, 30.0F}, {330.0F, 450.0F}};
        const Rect editor{{10.0F, 470.0F}, {330.0F, 960.0F}};
        const Rect vibration{{350.0F, 30.0F}, {1040.0F, 960.0F}};
        const Rect space{{1060.0F, 30.0F}, {1590.0F, 570.0F}};
        const Rect matrix{{1060.0F, 600.0F}, {1590.0F, 960.0F}};
        for (const Rect& pane : {patterns, editor, vibration, space, matrix}) {
            CHECK(count_pixels(image, pane, theme.pane) > 1000);
            CHECK(colours_in(image, pane) > 20);
        }
        // The first pattern's colour: in the list, its waveform and its point.
        for (const Rect& pane : {patterns, vibration, space}) {
            CHECK(count_pixels(image, pane, theme.pattern[0]) > 20);
        }
    }
}

TEST_CASE("pictures: a set of none or one has its window, too") {
    PatternSet set = three_patterns();
    PictureSize size;
    set.vibrations.resize(1);
    CHECK(colours_in(std::get<Image>(window_picture(set, 1, size)), {{0, 0}, {1000, 900}}) > 20);
    set.vibrations.clear();
    CHECK(colours_in(std::get<Image>(window_picture(set, 1, size)), {{0, 0}, {1000, 900}}) > 20);
}
