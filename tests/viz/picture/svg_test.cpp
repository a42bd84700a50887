#include "viz/picture/svg.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/support/drawn_svg.h"
#include "tests/support/svg_elements.h"
#include "tests/support/temporary_folder.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/picture/picture.h"

namespace tact::svg_test {
namespace {

constexpr double kWrittenPx = 0.011;  // lengths are written to 1/100 px

// Without the ground, which is the first rectangle of a picture and not in <defs>.
std::vector<SvgElement> rects_of(const std::string& svg) {
    std::vector<SvgElement> rects = elements_of(svg, "rect");
    std::erase_if(rects, [](const SvgElement& e) { return e.above.back() == "clipPath"; });
    rects.erase(rects.begin());
    return rects;
}

void check_rect(const SvgElement& rect, double x, double y, double width, double height) {
    CHECK(rect.number("x") == x);
    CHECK(rect.number("y") == y);
    CHECK(rect.number("width") == width);
    CHECK(rect.number("height") == height);
}

// The corners of the one outline in a path's data.
std::vector<ImVec2> corners_of(std::string path) {
    for (char& c : path) c = std::string_view("MLZ").find(c) != std::string_view::npos ? ' ' : c;
    std::istringstream stream(path);
    std::vector<ImVec2> corners;
    for (ImVec2 p; stream >> p.x >> p.y;) corners.push_back(p);
    return corners;
}

double area_of(const std::vector<ImVec2>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ImVec2 a = corners[i];
        const ImVec2 b = corners[(i + 1) % corners.size()];
        twice += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
    }
    return std::abs(twice) / 2.0;
}

}  // namespace

TEST_CASE("svg: an empty picture is its ground, in its size and colour") {
    const std::string svg = drawn_svg([](ImDrawList&, const Theme&) {});
    const auto all = elements_of(svg);
    REQUIRE(all.size() == 2);
    CHECK(all[0].name == "svg");
    CHECK(all[0].value("viewBox") == "0 0 200 100");
    CHECK(all[1].value("fill") == "#1b1f24");  // the dark theme's pane
    check_rect(all[1], 0, 0, 200, 100);
}

TEST_CASE("svg: a disc of any size is a circle at its place") {
    for (const float radius : {1.6F, 4.0F, 11.25F, 40.0F}) {
        const std::string svg = drawn_svg([&](ImDrawList& list, const Theme& theme) {
            draw_disc(list, theme, {70.5F, 45.25F}, radius, faded(rgb(0x56B4E9), 0.5F));
        });
        const auto circles = elements_of(svg, "circle");
        REQUIRE(circles.size() == 1);
        CHECK(std::abs(circles[0].number("cx") - 70.5) <= kWrittenPx);
        CHECK(std::abs(circles[0].number("cy") - 45.25) <= kWrittenPx);
        CHECK(std::abs(circles[0].number("r") - static_cast<double>(radius)) <= kWrittenPx);
        CHECK(circles[0].value("fill") == "#56b4e9");
        CHECK(circles[0].value("fill-opacity") == "0.5");
    }
}

TEST_CASE("svg: what leaves its clip rectangle is cut, what does not is left alone") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme& theme) {
        list.PushClipRect({20, 30}, {60, 50});
        list.AddRectFilled({0, 0}, {40, 100}, IM_COL32_WHITE);
        list.AddTriangleFilled({25, 35}, {55, 35}, {40, 45}, IM_COL32_WHITE);  // inside
        list.AddTriangleFilled({25, 35}, {90, 35}, {40, 45}, theme.accent);
        draw_disc(list, theme, {40, 20}, 5.0F, IM_COL32_WHITE);  // outside
        draw_disc(list, theme, {40, 30}, 5.0F, IM_COL32_WHITE);
        draw_text(list, theme.fonts.small, {50, 34}, theme.text, "beyond");
        list.PopClipRect();
    });
    const auto rects = rects_of(svg);
    REQUIRE(rects.size() == 1);
    check_rect(rects[0], 20, 30, 20, 20);
    const auto clips = elements_of(svg, "clipPath");
    REQUIRE(clips.size() == 1);
    for (const SvgElement& rect : elements_of(svg, "rect")) {
        if (rect.above.back() == "clipPath") check_rect(rect, 20, 30, 40, 20);
    }
    const std::string cut = "url(#" + clips[0].value("id") + ")";
    const auto paths = elements_of(svg, "path");
    REQUIRE(paths.size() == 2);
    CHECK(paths[0].value("clip-path") == "");
    CHECK(paths[1].value("clip-path") == cut);
    const auto circles = elements_of(svg, "circle");
    REQUIRE(circles.size() == 1);
    CHECK(circles[0].value("clip-path") == cut);
    const auto groups = elements_of(svg, "g");
    REQUIRE(groups.size() == 1);  // around the text
    CHECK(groups[0].value("clip-path") == cut);
}

TEST_CASE("svg: a polyline is a stroke through its points, a single line, too") {
    const std::vector<ImVec2> points{{10, 80}, {30, 20}, {50.5F, 70}, {90, 70}, {120, 12.25F}};
    const std::string svg = drawn_svg([&](ImDrawList& list, const Theme&) {
        list.AddPolyline(points.data(), static_cast<int>(points.size()), rgb(0xE69F00), 0, 1.5F);
        list.AddLine({150, 10}, {190, 90}, rgb(0x009E73), 2.0F);
    });
    const auto paths = elements_of(svg, "path");
    REQUIRE(paths.size() == 2);
    CHECK(paths[0].value("fill") == "none");
    CHECK(paths[0].value("stroke") == "#e69f00");
    CHECK(paths[0].number("stroke-width") == 1.5);
    const auto corners = corners_of(paths[0].value("d"));
    REQUIRE(corners.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(std::abs(corners[i].x - points[i].x) <= 0.02);
        CHECK(std::abs(corners[i].y - points[i].y) <= 0.02);
    }
    CHECK(paths[1].value("d") == "M150.5 10.5L190.5 90.5");  // ImGui draws at pixel centres
}

TEST_CASE("svg: a frame is a closed stroke and a full circle has its area") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        list.AddRect({10, 10}, {50, 40}, rgb(0xFFFFFF), 4.0F, 0, 1.0F);
        list.AddCircleFilled({120, 50}, 30.0F, rgb(0xD55E00));
    });
    const auto paths = elements_of(svg, "path");
    REQUIRE(paths.size() == 2);
    CHECK(paths[0].value("d").ends_with("Z"));
    CHECK(paths[0].value("fill") == "none");
    const double area = area_of(corners_of(paths[1].value("d")));
    // Flattened to 0.05 px: a ring of at most that width is missing.
    const double circle = std::numbers::pi * 30.0 * 30.0;
    CHECK(area <= circle + 0.5);
    CHECK(area >= circle - 2.0 * std::numbers::pi * 30.0 * 0.05);
}

TEST_CASE("svg: a drawn waveform is one shape, not a triangle a pixel") {
    std::vector<double> samples;
    for (int i = 0; i < 10'000; ++i) samples.push_back(std::sin(0.4 * i));
    const std::string svg = drawn_svg([&](ImDrawList& list, const Theme& theme) {
        Plot plot;
        plot.area = {{10, 10}, {190, 90}};
        plot.x = {0.0, 1.0, Scale::linear, 10, 190};
        plot.y = {-1.0, 1.0, Scale::linear, 90, 10};
        draw_signal(list, theme, plot, samples, 10'000.0, theme.accent, TraceStyle::line);
    });
    const auto paths = elements_of(svg, "path");
    REQUIRE(paths.size() == 1);
    const double area = area_of(corners_of(paths[0].value("d")));
    // A band of 80 px and the line's width, over 180 columns less half of one at each end.
    CHECK(area > 179.0 * 79.0);
    CHECK(area < 180.0 * 83.0);
}

TEST_CASE("svg: cells that touch are not smoothed, so that no ground shines through") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        for (int i = 0; i < 40; ++i) {
            const ImVec2 corner{static_cast<float>(10 + 4 * (i % 8)),
                                static_cast<float>(4 * (i / 8))};
            const ImVec2 end{corner.x + 4.0F, corner.y + 4.0F};
            list.AddRectFilled(corner, end, rgb(static_cast<unsigned>(i * 0x030201)));
        }
    });
    const auto groups = elements_of(svg, "g");
    REQUIRE(groups.size() >= 1);
    CHECK(groups[0].value("shape-rendering") == "crispEdges");
}

TEST_CASE("svg: very many cells are gathered by colour, and cover what they covered") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        list.AddRectFilled({0, 0}, {200, 100}, rgb(0x00FF00));  // under them, and first
        for (int i = 0; i < 20'000; ++i) {
            const ImVec2 corner{static_cast<float>(i % 200), static_cast<float>(i / 200)};
            const ImU32 colour = (i + i / 200) % 2 == 0 ? rgb(0xFF0000) : rgb(0x0000FF);
            list.AddRectFilled(corner, {corner.x + 1.0F, corner.y + 1.0F}, colour);
        }
    });
    CHECK(svg.size() < 20'000 * 20);
    const auto paths = elements_of(svg, "path");
    REQUIRE(paths.size() == 2);
    CHECK(rects_of(svg).size() == 1);
    for (const SvgElement& path : paths) {
        CHECK(path.above.back() == "g");
        CHECK(std::ranges::count(path.value("d"), 'M') == 10'000);
        const std::string first = path.value("fill") == "#ff0000" ? "M0 0" : "M1 0";
        CHECK(path.value("d").starts_with(first + "h1v1h-1z"));
    }
}

TEST_CASE("svg: cells that cover each other keep their order") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        for (int i = 0; i < 3000; ++i) {
            const ImU32 colour = i == 2999 ? rgb(0xFF0000) : rgb(0x0000FF + (i % 2U) * 0x100U);
            list.AddRectFilled({10, 10}, {20, 20}, colour);
        }
    });
    CHECK(rects_of(svg).back().value("fill") == "#ff0000");
}

TEST_CASE("svg: colours that change along a side become a gradient") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        const ImU32 left = rgb(0xFF0000);
        const ImU32 right = faded(rgb(0x0000FF), 0.0F);
        list.AddRectFilledMultiColor({20, 30}, {120, 60}, left, right, right, left);
    });
    const auto gradients = elements_of(svg, "linearGradient");
    REQUIRE(gradients.size() == 1);
    CHECK(std::min(gradients[0].number("x1"), gradients[0].number("x2")) == 20.0);
    CHECK(std::max(gradients[0].number("x1"), gradients[0].number("x2")) == 120.0);
    CHECK(gradients[0].number("y1") == gradients[0].number("y2"));
    const auto stops = elements_of(svg, "stop");
    REQUIRE(stops.size() == 2);
    const bool forward = gradients[0].number("x1") == 20.0;
    CHECK(stops[forward ? 0 : 1].value("stop-color") == "#ff0000");
    CHECK(stops[forward ? 1 : 0].value("stop-opacity") == "0");
    REQUIRE(elements_of(svg, "path").size() == 1);
    CHECK(area_of(corners_of(elements_of(svg, "path")[0].value("d"))) == 3000.0);
}

TEST_CASE("svg: the same drawing gives the same bytes, and leaves the current context alone") {
    ImGuiContext* const before = ImGui::GetCurrentContext();
    const auto draw = [](ImDrawList& list, const Theme& theme) {
        ImGui::TextUnformatted("Perceptual space");
        draw_disc(list, theme, {50, 60}, 20.3F, theme.accent);
    };
    CHECK((drawn_svg(draw) == drawn_svg(draw)));
    CHECK(ImGui::GetCurrentContext() == before);
}

TEST_CASE("svg: coordinates that are no numbers are left out") {
    const std::string svg = drawn_svg([](ImDrawList& list, const Theme&) {
        list.AddLine({NAN, 10}, {20, 30}, IM_COL32_WHITE);
        list.AddTriangleFilled({INFINITY, 10}, {20, NAN}, {NAN, 30}, IM_COL32_WHITE);
    });
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("svg: a file that cannot be written fails with a sentence") {
    const auto result = write_svg("/nonexistent/folder/picture.svg", "<svg/>");
    REQUIRE_FALSE(result);
    CHECK(result.error().message.find("picture.svg") != std::string::npos);
}

}  // namespace tact::svg_test
