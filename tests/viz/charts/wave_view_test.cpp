#include "viz/charts/wave_view.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/presence.h"

namespace tact::wave_view_test {
namespace {

std::vector<double> sine(double frequency_hz, double amplitude_g) {
    std::vector<double> samples(10'000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = amplitude_g *
                     std::sin(2 * std::numbers::pi * frequency_hz * static_cast<double>(i) / 1e4);
    }
    return samples;
}

const Rect kArea{{10, 10}, {590, 190}};

Image picture(const WaveScene& scene, std::optional<ImVec2> mouse, WaveAction* action) {
    return draw_picture(600, 200, {.mouse_px = mouse}, [&](const Theme& theme) {
        const WaveAction result = draw_wave("wave", theme, kArea, scene);
        if (action != nullptr) *action = result;
    });
}

}  // namespace

TEST_CASE("wave: a long and a short stretch of a signal both show in its colour") {
    const auto samples = sine(150.0, 1.0);
    const std::array<WaveTrace, 1> traces{WaveTrace{samples, 1e4, IM_COL32(255, 0, 200, 255)}};
    for (const double end_s : {1.0, 0.02}) {
        const Image image = picture({.traces = traces, .end_s = end_s}, std::nullopt, nullptr);
        CHECK(count_pixels(image, kArea, traces[0].colour, 40) > 500);
    }
}

TEST_CASE("wave: silence is a line at zero, not a blank pane") {
    const std::vector<double> silence(10'000, 0.0);
    const std::array<WaveTrace, 1> traces{WaveTrace{silence, 1e4, IM_COL32(255, 0, 200, 255)}};
    const Image image = picture({.traces = traces}, std::nullopt, nullptr);
    CHECK(count_pixels(image, kArea, traces[0].colour, 60) > 300);
}

TEST_CASE("wave: the playhead stands at its time") {
    const std::array<WaveTrace, 0> none{};
    const Image image = picture({.traces = none, .playhead_s = 0.5}, std::nullopt, nullptr);
    const ImU32 accent = dark_theme(1.0F).accent;
    CHECK(count_pixels(image, kArea, accent, 10) > 100);
    CHECK(count_pixels(image, {{280, 10}, {350, 190}}, accent, 10) ==
          count_pixels(image, kArea, accent, 10));
}

TEST_CASE("wave: the mouse reads the time under it") {
    const auto samples = sine(4.0, 1.0);
    const std::array<WaveTrace, 1> traces{WaveTrace{samples, 1e4, IM_COL32_WHITE}};
    WaveAction left;
    WaveAction right;
    picture({.traces = traces}, ImVec2{150, 80}, &left);
    picture({.traces = traces}, ImVec2{500, 80}, &right);
    REQUIRE(left.hovered_s.has_value());
    REQUIRE(right.hovered_s.has_value());
    CHECK(*left.hovered_s > 0.1);
    CHECK(*left.hovered_s < 0.35);
    CHECK(*right.hovered_s > *left.hovered_s);
    CHECK_FALSE(left.scrubbed_s.has_value());
}

TEST_CASE("wave: an area without room draws nothing and does not fail") {
    draw_picture(50, 50, {}, [](const Theme& theme) {
        draw_wave("none", theme, {{10, 10}, {10, 10}}, {});
        draw_wave("tiny", theme, {{10, 10}, {13, 12}}, {});
    });
}

}  // namespace tact::wave_view_test
