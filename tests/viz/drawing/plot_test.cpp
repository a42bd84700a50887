#include "viz/drawing/plot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/support/drawn_svg.h"
#include "tests/support/svg_elements.h"
#include "viz/drawing/marks.h"

namespace tact::plot_test {

TEST_CASE("plot: any range gets three to five ticks, all inside it and evenly spaced") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-6.0, 6.0);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int trial = 0; trial < 2000; ++trial) {
        const double width = std::pow(10.0, exponent(random));
        const double low = place(random) * width * 3.0;
        const auto ticks = round_ticks(low, low + width);
        REQUIRE(ticks.size() >= 3);
        REQUIRE(ticks.size() <= 5);
        const double step = ticks[1] - ticks[0];
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            CHECK(ticks[i] >= low - 1e-9 * width);
            CHECK(ticks[i] <= low + width * (1 + 1e-9));
            // Rounding of sums of magnitude up to 4 widths.
            if (i > 0) CHECK(std::abs(ticks[i] - ticks[i - 1] - step) <= 1e-9 * width);
        }
        const double mantissa = step / std::pow(10.0, std::floor(std::log10(step * (1 + 1e-9))));
        const bool round = std::abs(mantissa - 1.0) < 1e-6 || std::abs(mantissa - 2.0) < 1e-6 ||
                           std::abs(mantissa - 2.5) < 1e-6 || std::abs(mantissa - 5.0) < 1e-6;
        CHECK_MESSAGE(round, "step ", step);
    }
}

TEST_CASE("plot: the audible ticks of touch are 1, 10 and 100 Hz") {
    CHECK(round_ticks(1.0, 500.0, Scale::logarithmic) == std::vector<double>{1.0, 10.0, 100.0});
}

TEST_CASE("plot: any logarithmic range of up to ten decades gets three to five ticks") {
    for (double high = 1.5; high < 2e10; high *= 1.37) {
        const auto ticks = round_ticks(1.0, high, Scale::logarithmic);
        CHECK_MESSAGE(ticks.size() >= 3, "up to ", high);
        CHECK_MESSAGE(ticks.size() <= 5, "up to ", high);
    }
}

TEST_CASE("plot: a range without extent has no ticks") {
    CHECK(round_ticks(1.0, 1.0).empty());
    CHECK(round_ticks(2.0, 1.0).empty());
    CHECK(round_ticks(0.0, INFINITY).empty());
}

TEST_CASE("plot: a pixel leads back to the value it shows") {
    const Axis linear{.low = -2.0, .high = 6.0, .low_px = 300.0F, .high_px = 20.0F};
    const Axis log{.low = 1, .high = 500, .scale = Scale::logarithmic, .low_px = 0, .high_px = 400};
    for (const double value : {1.0, 2.5, 5.5}) {
        // Pixels are floats: 300 px has steps of 3e-5 px, times 8 units over 280 px.
        CHECK(std::abs(to_value(linear, to_pixel(linear, value)) - value) <= 1e-5);
        CHECK(std::abs(to_value(log, to_pixel(log, value)) - value) <= 1e-5 * value);
    }
    CHECK(to_pixel(log, 1.0) == 0.0F);
    CHECK(std::abs(to_pixel(log, 500.0) - 400.0F) <= 1e-3F);
}

TEST_CASE("plot: thinning keeps the largest and the smallest sample") {
    std::vector<double> samples(100'000, 0.1);
    samples[12'345] = 7.0;
    samples[99'999] = -3.0;
    samples[0] = 5.0;
    for (const std::size_t columns : {1U, 10U, 777U, 1600U}) {
        const auto e = extremes(samples, 0.0, 100'000.0, columns);
        REQUIRE(e.size() == columns);
        CHECK(e.front().high >= 5.0);
        CHECK(e.back().low == -3.0);
        CHECK(std::max_element(e.begin(), e.end(), [](const Extremes& a, const Extremes& b) {
                  return a.high < b.high;
              })->high == 7.0);
    }
}

// A ramp is the hard case: its columns share no value unless they share a sample.
TEST_CASE("plot: neighbouring columns of a thinned signal touch") {
    std::vector<double> ramp(5000);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<double>(i);
    for (const std::size_t columns : {10U, 333U, 5000U, 9000U}) {
        const auto e = extremes(ramp, 0.0, 5000.0, columns);
        for (std::size_t i = 1; i < e.size(); ++i) {
            CHECK(e[i].low <= e[i - 1].high);
            CHECK(e[i].high >= e[i - 1].low);
        }
    }
}

TEST_CASE("plot: a signal without samples has no columns") {
    CHECK(extremes({}, 0.0, 10.0, 5).empty());
    CHECK(extremes(std::vector<double>{1.0}, 3.0, 3.0, 5).empty());
}

TEST_CASE("plot: numbers read as a person would write them") {
    CHECK(tick_text(0.25) == "0.25");
    CHECK(tick_text(1000.0) == "1000");
    CHECK(tick_text(-20.0) == "−20");
}

// Deep in a long signal steps are small beside the values.
TEST_CASE("plot: no two ticks read alike, and each reads as what it is") {
    for (const double low : {0.0, 0.3, 9.99, 59.895, 599.87, -59.9}) {
        for (double width = 100.0; width > 1e-5; width /= 3.1) {
            const auto ticks = round_ticks(low, low + width);
            REQUIRE(ticks.size() > 1);
            const double step = ticks[1] - ticks[0];
            for (const double tick : ticks) {
                std::string text = tick_text(tick, step);
                if (text.starts_with("−")) text.replace(0, 3, "-");
                CHECK_MESSAGE(std::abs(std::stod(text) - tick) <= 1e-3 * step, text);
            }
        }
    }
    CHECK(tick_text(0.25, 0.25) == "0.25");
    CHECK(tick_text(0.5, 0.25) == "0.5");
    CHECK(tick_text(1000.0, 500.0) == "1000");
    CHECK(tick_text(59.8925, 0.0025) == "59.8925");
    CHECK(tick_text(0.0, 0.0) == "0");
}

TEST_CASE("plot: a place is read to a fraction of what is in view, early and late alike") {
    CHECK(place_text({.low = 0.0, .high = 1.0}, 0.25317) == "0.253");
    CHECK(place_text({.low = 0.0, .high = 60.0}, 31.256) == "31.3");
    CHECK(place_text({.low = 59.895, .high = 59.9}, 59.8973149) == "59.89731");
    CHECK(place_text({.low = -1.0, .high = 1.0}, -0.25) == "−0.250");
    for (const double at : {0.1, 6.0, 59.9}) {
        for (double length = 1.0; length > 1e-3; length *= 0.37) {
            const Axis axis{.low = at - length, .high = at};
            // Less than a pixel of the largest screen apart is alike, a hundredth of the view not.
            CHECK(place_text(axis, at) != place_text(axis, at - 0.01 * length));
        }
    }
    CHECK(stepped(3.0, 0.0) == "3");
}

// The last number has the unit, and gives way to the left where the plot ends.
TEST_CASE(
    "plot: however narrow it is, no number along it runs into the next, and the unit is told" *
    doctest::test_suite("long")) {
    for (float width = 40.0F; width < 200.0F; width += 3.0F) {
        std::map<std::string, float> widths;
        const std::string svg = drawn_svg([&](ImDrawList& list, const Theme& theme) {
            const PlotLabels labels{.x_unit = "Hz", .y_unit = "", .y_grid = false};
            const Axis x{.low = 0.5, .high = 1000.0, .scale = Scale::logarithmic};
            const Plot plot = plot_within({{0.0F, 0.0F}, {width, 90.0F}}, theme, x,
                                          {.low = 0.0, .high = 1.0}, labels);
            draw_axes(list, theme, plot, labels);
            for (const double tick : round_ticks(x.low, x.high, x.scale)) {
                for (const std::string unit : {"", " Hz"}) {
                    const std::string text = tick_text(tick) + unit;
                    widths[text] = text_size(theme.fonts.small, text).x;
                }
            }
        });
        double end = -1.0;
        const auto texts = elements_of(svg, "text");
        std::vector<std::pair<double, std::string>> places;
        for (const SvgElement& text : texts) places.emplace_back(text.number("x"), text.text);
        std::ranges::sort(places);
        REQUIRE_FALSE(places.empty());
        CHECK(places.back().second.ends_with("Hz"));
        for (const auto& [left, words] : places) {
            CAPTURE(words);
            CHECK(left > end);
            end = left + static_cast<double>(widths.at(words));
        }
    }
}

TEST_CASE("plot: a low plot says zero and how far it reaches") {
    const std::string svg = drawn_svg([&](ImDrawList& list, const Theme& theme) {
        const PlotLabels labels{.x_unit = "", .y_unit = ""};
        const Plot plot =
            plot_within({{0.0F, 0.0F}, {300.0F, 42.0F}}, theme, {.low = 0.0, .high = 1.0},
                        {.low = -52.5, .high = 52.5}, labels);
        draw_axes(list, theme, plot, labels);
    });
    std::vector<std::string> numbers;
    for (const SvgElement& text : elements_of(svg, "text")) numbers.push_back(text.text);
    CHECK(numbers == std::vector<std::string>{"0", "50"});
}

}  // namespace tact::plot_test

TEST_CASE("ticks: bounds that differ by rounding alone have none, instead of no end of them") {
    const double low = 0.1 + 0.2;
    CHECK(low > 0.3);
    CHECK(tact::round_ticks(0.3, low).empty());
    CHECK(tact::round_ticks(1e9, 1e9 + 1e-6).empty());
    CHECK_FALSE(tact::round_ticks(0.0, 1e-12).empty());
}
