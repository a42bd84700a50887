#include "app/pictures/pictures.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "app/window/window.h"
#include "tests/support/presence.h"
#include "tests/support/svg_elements.h"
#include "viz/drawing/theme.h"

namespace pictures_test {

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

Picture window_picture(const PatternSet& set, int threads, const PictureSize& size) {
    ViewChoice choice;
    choice.threads = threads;
    const auto view = opened_view(set, choice);
    return view_picture(*view, PictureView::window, 0.0, size);
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

namespace {

Dissimilarity distances(std::size_t n) {
    Dissimilarity result{n, {}};
    for (std::size_t k = 0; k < pair_count(n); ++k) {
        result.condensed.push_back(1.0 + static_cast<double>(k));
    }
    return result;
}

}  // namespace

TEST_CASE("pictures: as SVG, a matrix names every pattern at its row and its column") {
    PictureSize size;
    size.format = PictureFormat::svg;
    const std::vector<std::string> labels{"60 Hz", "150 Hz", "a <long> & wide name of a pattern"};
    for (const bool dark : {true, false}) {
        size.dark = dark;
        const auto svg = std::get<Svg>(matrix_picture(labels, distances(3), "PM", size)).text;
        CHECK(text_count(svg, "60 Hz") == 2);
        CHECK(text_count(svg, "150 Hz") == 2);
        CHECK(text_count(svg, labels[2]) == 2);
        CHECK(text_count(svg, "PM") == 1);
        for (const std::string value : {"1.00", "2.00"}) CHECK(text_count(svg, value) == 2);
    }
}

TEST_CASE("pictures: a distance that is rounding alone is read as 0") {
    PictureSize size;
    size.format = PictureFormat::svg;
    const Dissimilarity matrix{3, {6.0, 6e-14, 0.25}};
    const auto svg =
        std::get<Svg>(matrix_picture({"a", "b", "c"}, matrix, "Level difference", size)).text;
    CHECK(text_count(svg, "6.00") >= 2);
    CHECK(text_count(svg, "0.250") == 2);
    CHECK(text_count(svg, "0") >= 2);
    CHECK(svg.find("0.00000") == std::string::npos);
}

TEST_CASE("pictures: as SVG, a space names every pattern once, beside its point") {
    PictureSize size;
    size.format = PictureFormat::svg;
    const PatternSet set = three_patterns();
    PerceptualSpace space;
    space.points.resize(3, 3);
    space.points << 0.0, 0.0, 0.0, 1.0, 0.2, 0.0, -0.6, 0.9, 0.3;
    const auto svg = std::get<Svg>(space_picture(set, distances(3), space, size)).text;
    const auto circles = elements_of(svg, "circle");
    for (const Vibration& vibration : set.vibrations) {
        CHECK(text_count(svg, vibration.name) == 1);
        for (const SvgElement& text : elements_of(svg, "text")) {
            if (text.text != vibration.name) continue;
            const double x = std::stod(text.value("x"));
            const bool beside = std::any_of(circles.begin(), circles.end(), [&](const auto& c) {
                return std::hypot(c.number("cx") - x, c.number("cy") - text.number("y")) < 60.0;
            });
            CHECK(beside);
        }
    }
    CHECK(circles.size() >= 6);  // a point and its rim each
}

TEST_CASE("pictures: as SVG, the window is small, whole and the same each time" *
          doctest::test_suite("long")) {
    PictureSize size;
    size.width = 1600;
    size.height = 1000;
    size.format = PictureFormat::svg;
    const auto draw = [&] { return std::get<Svg>(window_picture(three_patterns(), 1, size)).text; };
    const std::string svg = draw();
    CHECK(svg.size() < 2'000'000);
    CHECK(elements_of(svg).front().number("width") == 1600.0);
    for (const std::string title : {"Patterns", "Editor", "Perceptual space"}) {
        CHECK(text_count(svg, title) == 1);
    }
    CHECK(text_count(svg, "Physiology") == 1);      // the tab of a workspace
    CHECK(text_count(svg, "Brain waveform") == 1);  // the stages are the editor's foot
    CHECK((draw() == svg));
}

}  // namespace pictures_test
