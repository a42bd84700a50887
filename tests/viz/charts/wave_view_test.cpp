#include "viz/charts/wave_view.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
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

// Counts of 5 ms steps, and the same as impulses at 10 kHz, as narrow as two pixels.
TEST_CASE("wave: a bar is a rectangle at any size of text and width of the pane") {
    const ImU32 ink = IM_COL32(255, 0, 200, 255);
    std::vector<double> steps(200);
    for (std::size_t k = 0; k < steps.size(); ++k)
        steps[k] = k % 7 == 2 ? 50.0 : 20.0 * static_cast<double>(k % 3);
    std::vector<double> fine;
    for (const double step : steps) fine.insert(fine.end(), 50, step);
    for (const float scale : {0.75F, 1.5F, 2.5F}) {
        for (const float width : {410.5F, 610.0F}) {
            for (const auto& [samples, rate_hz] :
                 {std::pair{steps, 200.0}, std::pair{fine, 10'000.0}}) {
                const WaveTrace trace{samples, rate_hz, ink, TraceStyle::filled};
                const Rect area{{10, 10}, {10.0F + width, 110}};
                const Image image = draw_picture(static_cast<int>(width) + 20, 120,
                                                 {.scale = scale}, [&](const Theme& theme) {
                                                     WaveScene scene{.traces = {&trace, 1}};
                                                     scene.signed_values = false;
                                                     scene.time_axis = scene.value_axis = false;
                                                     draw_wave("wave", theme, area, scene);
                                                 });
                // Lower than any bar, and between the two kinds: vertical sides have no slope.
                for (const auto& [top, bottom] : {std::pair{80, 105}, {40, 65}, {18, 31}}) {
                    int slanted = 0;
                    for (int x = 10; x < static_cast<int>(area.max.x); ++x) {
                        for (int y = top + 1; y < bottom; ++y) {
                            if (pixel(image, x, y) != pixel(image, x, top)) ++slanted;
                        }
                    }
                    CHECK_MESSAGE(slanted == 0, "scale ", scale, ", ", width, " px");
                }
                // Bars cross this row, fainter than their edge; beside the plot there is no bar.
                const Rect row{{10, 30}, {area.max.x, 31}};
                const int free = count_pixels(image, row, pixel(image, 5, 30));
                CHECK(static_cast<float>(free) < 0.9F * width);
                CHECK(free > 0);
                CHECK(count_pixels(image, area, ink) > width / 10.0F);  // the edge at their tops
            }
        }
    }
}

TEST_CASE("wave: the stroke of a crest is as thick as any other") {
    const ImU32 ink = IM_COL32(255, 0, 200, 255);
    for (const double rate_hz : {100.0, 10'000.0}) {
        const std::vector<double> level(static_cast<std::size_t>(rate_hz), 1.0);
        const auto inked = [&](double highest) {
            const Image image = draw_picture(320, 60, {.scale = 2.0F}, [&](const Theme& theme) {
                Plot plot;
                plot.area = {{10, 20}, {310, 40}};
                plot.x = {0.0, 1.0, Scale::linear, 10, 310};
                plot.y = {-highest, highest, Scale::linear, 40, 20};
                draw_signal(*ImGui::GetWindowDrawList(), theme, plot, level, rate_hz, ink,
                            TraceStyle::line);
            });
            return count_pixels(image, whole(image), ink, 100);
        };
        CHECK(inked(1.0) == inked(2.0));
    }
}

}  // namespace tact::wave_view_test
