#include "viz/charts/spectrum_view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "model/common/units.h"
#include "tests/support/presence.h"

namespace tact::spectrum_view_test {
namespace {

Component component(double frequency_hz, double amplitude_g) {
    return {frequency_hz, amplitude_g, displacement_um(amplitude_g, frequency_hz)};
}

const Rect kArea{{10, 10}, {590, 290}};

Image picture(std::span<const Component> components, ImU32 colour, SpectrumAction* action = nullptr,
              std::optional<ImVec2> mouse = std::nullopt) {
    return draw_picture(600, 300, {.mouse_px = mouse}, [&](const Theme& theme) {
        const SpectrumScene scene{
            .components = components, .thresholds = &default_tables().threshold, .colour = colour};
        const SpectrumAction result = draw_spectrum("spectrum", theme, kArea, scene);
        if (action != nullptr) *action = result;
    });
}

constexpr ImU32 kInk = IM_COL32(255, 255, 0, 255);

}  // namespace

// a = (2 pi f)^2 v: 1 g at 100 Hz is 24.84 um, 27.9 dB.
TEST_CASE("spectrum: 1 g at 100 Hz is 27.9 dB re 1 um") {
    CHECK(std::abs(level_db(component(100.0, 1.0)) - 27.904) <= 1e-3);
}

TEST_CASE("spectrum: only Pacinian afferents reach their threshold for a faint 250 Hz") {
    const double um = std::pow(10.0, at(default_tables().threshold[1], 250.0)) * 1.2;
    const Component faint = component(250.0, um / displacement_um(1.0, 250.0));
    const auto hears = reached(std::span{&faint, 1}, default_tables().threshold);
    CHECK(hears[index_of(Receptor::pacinian)]);
    CHECK_FALSE(hears[index_of(Receptor::meissner)]);
    CHECK_FALSE(hears[index_of(Receptor::merkel)]);
    CHECK_FALSE(hears[index_of(Receptor::ruffini)]);
}

TEST_CASE("spectrum: what is felt has the strong colour, what is not has none of it") {
    const std::vector<Component> felt{component(70.0, 1.0), component(210.0, 1.0)};
    const std::vector<Component> not_felt{component(70.0, 1e-4)};
    CHECK(count_pixels(picture(felt, kInk), kArea, kInk, 20) > 60);
    CHECK(count_pixels(picture(not_felt, kInk), kArea, kInk, 20) == 0);
}

TEST_CASE("spectrum: all four thresholds are drawn even for silence") {
    const Image image = picture({}, kInk);
    const Theme theme = dark_theme(1.0F);
    for (const ImU32 receptor : theme.receptor) {
        // Dimmed to 45 %: searched for between the two colours.
        int found = 0;
        for (const float strength : {0.35F, 0.45F, 0.55F}) {
            const auto blend = [&](unsigned shift) {
                const auto a = static_cast<float>((theme.pane >> shift) & 0xFFU);
                const auto b = static_cast<float>((receptor >> shift) & 0xFFU);
                return static_cast<ImU32>(a + (b - a) * strength) << shift;
            };
            found +=
                count_pixels(image, kArea, blend(0) | blend(8) | blend(16) | IM_COL32_A_MASK, 6);
        }
        CHECK(found > 50);
    }
}

TEST_CASE("spectrum: the mouse over a component's bar names it" * doctest::test_suite("long")) {
    const std::vector<Component> components{component(22.4, 0.1)};
    int hits = 0;
    for (float x = 20.0F; x < 500.0F; x += 8.0F) {
        SpectrumAction action;
        picture(components, kInk, &action, ImVec2{x, 150});
        if (action.hovered) {
            ++hits;
            CHECK(*action.hovered == 0);
        }
    }
    CHECK(hits >= 1);
    CHECK(hits <= 2);  // within 6 px of the bar
}

TEST_CASE("spectrum: labels spread apart keep their order, their distance and the pane") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-20.0F, 220.0F);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<float> wanted(4);
        for (float& w : wanted) w = value(random);
        const auto tops = spread(wanted, 14.0F, 0.0F, 200.0F);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(tops[i] >= 0.0F);
            CHECK(tops[i] <= 200.0F - 14.0F);
            for (std::size_t j = 0; j < 4; ++j) {
                // Float sums of magnitude 200.
                if (wanted[i] < wanted[j]) CHECK(tops[j] - tops[i] >= 14.0F - 1e-3F);
            }
        }
    }
}

}  // namespace tact::spectrum_view_test
