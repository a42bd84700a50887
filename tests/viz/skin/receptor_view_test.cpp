#include "viz/skin/receptor_view.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "model/physiology/spike_train.h"
#include "tests/support/drawn_view.h"
#include "tests/support/headless_window.h"
#include "tests/support/presence.h"
#include "viz/drawing/colour.h"
#include "viz/skin/raster_view.h"
#include "viz/skin/receptor_caption.h"

namespace tact::receptor_view_test {
namespace {

const Rect kArea{{10, 10}, {230, 270}};

struct Example {
    Activation activation{.rate_hz = 190.0, .slope_sum = 80.0};
    ReceptorGrid grid;
    Receptor receptor;

    Example(Receptor type, double radius_mm) : receptor(type) {
        activation.radius_mm = radius_mm;
        if (radius_mm <= 0.0) activation = {};
        // The slope for which the rate is zero at the radius.
        if (radius_mm > kHotZoneMm) {
            activation.slope_sum = activation.rate_hz / (2.0 * std::log10(radius_mm / kHotZoneMm));
        }
        grid = receptor_grid(activation, type, 1.0, FireSharing::total);
    }

    ReceptorScene scene() const {
        return {.receptor = receptor, .grid = &grid, .activation = activation};
    }
    ImVec2 place(const ReceptorLayout& layout, const ReceptorScene& shown, std::size_t i) const {
        const GridReceptor& r = grid.receptors[i];
        return to_pixel(layout.skin, grid.x_mm(r), grid.y_mm(r), shown_value(shown, r.distance_mm));
    }
};

using Drawn = DrawnView<ReceptorAction, ReceptorLayout>;

Drawn drawn(const ReceptorScene& scene, const PictureOptions& options = {},
            const Rect& area = kArea) {
    return drawn_view<ReceptorAction, ReceptorLayout>(
        options, area,
        [&](const Theme& theme) { return draw_receptors("receptors", theme, area, scene); },
        [&](const Theme& theme) { return receptor_layout(theme, area, scene); });
}

Theme theme_of(const PictureOptions& options) {
    return options.dark ? dark_theme(options.scale) : light_theme(options.scale);
}

}  // namespace

TEST_CASE("receptor view: each type shows in its own colour, in both themes") {
    for (const Receptor receptor : kReceptors) {
        for (const bool dark : {true, false}) {
            const PictureOptions options{.dark = dark};
            const Example e(receptor, 6.0);
            const Drawn d = drawn(e.scene(), options);
            const ImU32 hue = theme_of(options).receptor[index_of(receptor)];
            CHECK(count_pixels(d.image, d.layout.map, hue, 12) > 8);
        }
    }
}

TEST_CASE("receptor view: distances are to scale, and the same for all types") {
    const Drawn meissner = drawn(Example(Receptor::meissner, 5.0).scene());
    const Drawn ruffini = drawn(Example(Receptor::ruffini, 9.0).scene());
    CHECK(meissner.layout.skin.px_per_mm == ruffini.layout.skin.px_per_mm);
    const SkinView& view = meissner.layout.skin;
    const ImVec2 a = to_pixel(view, -3.0, 1.0);
    const ImVec2 b = to_pixel(view, 1.0, 4.0);
    // 3-4-5 mm; float pixels.
    CHECK(std::abs(std::hypot(a.x - b.x, a.y - b.y) - 5.0F * view.px_per_mm) <= 1e-3F);
    CHECK(std::abs(2.0F * 10.5F * view.px_per_mm - meissner.layout.map.width()) <= 1e-3F);
}

TEST_CASE("receptor view: the common extent holds the fingertip and every activated receptor") {
    PerReceptor<Activation> activation{};
    CHECK(common_extent_mm(activation) >= kFingertipLengthMm / 2.0);
    activation[1] = Example(Receptor::pacinian, 14.0).activation;
    CHECK(common_extent_mm(activation) >= 14.0);
}

TEST_CASE("receptor view: a receptor that fires stands out, and fades back") {
    for (const bool dark : {true, false}) {
        const PictureOptions options{.dark = dark};
        const Example e(Receptor::meissner, 5.0);
        const Theme theme = theme_of(options);
        const auto contrasting = [&](float strength) {
            std::vector<float> flash(e.grid.receptors.size(), 0.0F);
            flash[flash.size() / 2] = strength;
            ReceptorScene scene = e.scene();
            scene.flash = flash;
            const Drawn d = drawn(scene, options);
            const ImVec2 at = e.place(d.layout, scene, flash.size() / 2);
            return contrast(pixel(d.image, static_cast<int>(at.x), static_cast<int>(at.y)),
                            theme.pane);
        };
        CHECK(contrasting(1.0F) > 1.4 * contrasting(0.0F));
        CHECK(contrasting(0.5F) < contrasting(1.0F));
        CHECK(contrasting(0.5F) > contrasting(0.0F));
    }
}

TEST_CASE("receptor view: the mouse over a receptor names it, flat, tilted and between" *
          doctest::test_suite("long")) {
    for (const float scale : {1.0F, 2.0F}) {
        const Rect area{kArea.min * scale, kArea.max * scale};
        for (const float tilted : {0.0F, 0.5F, 1.0F}) {
            const Example e(Receptor::ruffini, 9.0);
            ReceptorScene scene = e.scene();
            scene.tilted = tilted;
            PictureOptions options{.scale = scale};
            const Drawn quiet = drawn(scene, options, area);
            CHECK_FALSE(quiet.action.hovered.has_value());
            for (std::size_t i = 0; i < e.grid.receptors.size(); i += 5) {
                options.mouse_px = e.place(quiet.layout, scene, i);
                const Drawn d = drawn(scene, options, area);
                REQUIRE(d.action.hovered.has_value());
                CHECK(*d.action.hovered == i);
                CHECK(same(d.action.hovered_at, *options.mouse_px));
                CHECK_FALSE(d.action.clicked.has_value());
            }
        }
    }
}

TEST_CASE("receptor view: a click on a receptor names it, one beside all says so") {
    const Example e(Receptor::pacinian, 6.0);
    const Theme theme = dark_theme(1.0F);
    const ReceptorLayout layout = [&] {
        HeadlessWindow window;
        ReceptorLayout result;
        window.settle([&] { result = receptor_layout(theme, kArea, e.scene()); });
        return result;
    }();
    const auto click = [&](ImVec2 at) {
        HeadlessWindow window;
        ReceptorAction seen;
        const auto draw = [&] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({300, 300});
            ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration);
            const ReceptorAction now = draw_receptors("receptors", theme, kArea, e.scene());
            if (now.clicked) seen.clicked = now.clicked;
            seen.clicked_empty = seen.clicked_empty || now.clicked_empty;
            ImGui::End();
        };
        window.move(at);
        window.settle(draw);
        window.click(at);
        window.settle(draw);
        return seen;
    };
    const ReceptorAction on = click(e.place(layout, e.scene(), 4));
    CHECK(on.clicked == 4U);
    CHECK_FALSE(on.clicked_empty);
    const ReceptorAction beside = click(layout.map.min + ImVec2{3, 3});
    CHECK_FALSE(beside.clicked.has_value());
    CHECK(beside.clicked_empty);
}

TEST_CASE("receptor view: a type below threshold keeps its centre, without its full colour") {
    const Example silent(Receptor::merkel, 0.0);
    CHECK(silent.grid.receptors.size() == 1);
    const Drawn d = drawn(silent.scene());
    const ImU32 hue = dark_theme(1.0F).receptor[index_of(Receptor::merkel)];
    CHECK(count_pixels(d.image, d.layout.map, hue, 12) == 0);
    ReceptorScene nothing = silent.scene();
    nothing.grid = nullptr;
    // The centre's mark is the difference; the words beneath differ too.
    CHECK(drawn(nothing).image != d.image);
    CHECK(shown_value(silent.scene(), 0.0) == 0.0);
}

TEST_CASE("receptor view: without a result there is a fingertip with words, and nothing to pick") {
    const ReceptorScene scene{.receptor = Receptor::merkel};
    PictureOptions options{.mouse_px = kArea.centre()};
    const Drawn d = drawn(scene, options);
    CHECK_FALSE(d.action.hovered.has_value());
    const Theme theme = dark_theme(1.0F);
    CHECK(count_pixels(d.image, d.layout.map, skin_colour(theme), 12) > 2000);
    CHECK(count_pixels(d.image, d.layout.caption, theme.dim_text, 40) > 30);
}

TEST_CASE("receptor view: stale receptors step back") {
    const Example e(Receptor::meissner, 5.0);
    ReceptorScene scene = e.scene();
    const ImU32 hue = dark_theme(1.0F).receptor[0];
    const Drawn fresh = drawn(scene);
    scene.stale = true;
    const Drawn stale = drawn(scene);
    CHECK(count_pixels(fresh.image, fresh.layout.map, hue, 12) > 100);
    CHECK(count_pixels(stale.image, stale.layout.map, hue, 12) == 0);
}

TEST_CASE("receptor view: marks, words and stems stay inside the area, however narrow" *
          doctest::test_suite("long")) {
    const Example e(Receptor::pacinian, 18.0);  // farther than the map's edge
    for (const float scale : {1.0F, 2.0F}) {
        for (const float tilted : {0.0F, 1.0F}) {
            for (const ImVec2 size : {ImVec2{40, 200}, {90, 100}, {160, 60}, {220, 260}}) {
                ReceptorScene scene = e.scene();
                scene.tilted = tilted;
                scene.selected = 0;
                const Rect area = rect_at({10.0F, 10.0F}, size * scale);
                const PictureOptions options{.scale = scale};
                const Drawn d = drawn(scene, options, area);
                CHECK(count_strays(d.image, area, theme_of(options).pane) == 0);
            }
        }
    }
}

TEST_CASE(
    "receptor view: in a low and wide area the map is as high as it, and words are beside it") {
    const Example e(Receptor::pacinian, 6.0);
    ReceptorScene scene = e.scene();
    scene.half_width_mm = 8.4;
    const Rect area{{10, 10}, {360, 120}};
    const Drawn d = drawn(scene, {}, area);
    REQUIRE(d.layout.beside);
    CHECK(d.layout.map.height() == area.height());
    CHECK(d.layout.map.width() < d.layout.map.height());  // no wider than the finger
    CHECK(d.layout.caption.min.x >= d.layout.map.max.x);
    CHECK(count_pixels(d.image, d.layout.caption, dark_theme(1.0F).dim_text, 30) > 100);
    CHECK(count_strays(d.image, area, dark_theme(1.0F).pane) == 0);
    CHECK_FALSE(drawn(scene).layout.beside);
}

TEST_CASE("receptor view: where no words fit there are none, rather than cut ones") {
    const Example e(Receptor::pacinian, 6.0);
    ReceptorScene scene = e.scene();
    scene.centre_spikes = 317;
    draw_picture(100, 100, {}, [&](const Theme& theme) {
        CHECK(receptor_state_text(scene, theme.fonts.small, 30.0F) == "317");
        CHECK(receptor_state_text(scene, theme.fonts.small, 5.0F).empty());
    });
}

TEST_CASE(
    "receptor view: what a filter leaks is never counted as firing, however short the words") {
    const Example e(Receptor::merkel, 6.0);
    ReceptorScene scene = e.scene();
    scene.centre_spikes = 317;
    scene.only_leaks = true;
    draw_picture(100, 100, {}, [&](const Theme& theme) {
        for (float room_px = 600.0F; room_px > 5.0F; room_px -= 5.0F) {
            const std::string words = receptor_state_text(scene, theme.fonts.small, room_px);
            CHECK(words.find("fires") == std::string::npos);
            CHECK(words.find("spikes") == std::string::npos);
            CHECK((words.empty() || words.find("leak") != std::string::npos));
        }
    });
}

TEST_CASE("receptor view: more than one impulse a cycle stands beside the count, large and small") {
    const Example e(Receptor::meissner, 6.0);
    ReceptorScene scene = e.scene();
    scene.centre_spikes = 345;
    scene.times_a_cycle = 11.5;
    draw_picture(100, 100, {}, [&](const Theme& theme) {
        CHECK(
            receptor_state_text(scene, theme.fonts.small, 1000.0F).find("345 in 1 s, 12 a cycle") !=
            std::string::npos);
        CHECK(receptor_state_text(scene, theme.fonts.small, 160.0F) ==
              "fires 345 in 1 s, 12 a cycle");
    });
}

TEST_CASE("receptor view: in the tilted view a stronger value stands higher, and it eases in") {
    const Example e(Receptor::meissner, 6.0);
    for (const auto quantity : {ReceptorQuantity::rate, ReceptorQuantity::amplitude}) {
        ReceptorScene scene = e.scene();
        scene.quantity = quantity;
        CHECK(shown_value(scene, 0.0) == 1.0);
        CHECK(shown_value(scene, kHotZoneMm) == 1.0);
        CHECK(shown_value(scene, 3.0) < 1.0);
        CHECK(shown_value(scene, 5.0) < shown_value(scene, 3.0));
    }
    const Rect square{{0, 0}, {200, 200}};
    const SkinView flat = skin_view(square, 10.0, 0.0F);
    const SkinView hardly = skin_view(square, 10.0, 0.001F);
    const SkinView tilted = skin_view(square, 10.0, 1.0F);
    const ImVec2 before = to_pixel(flat, 4.0, -5.0, 1.0);
    const ImVec2 after = to_pixel(hardly, 4.0, -5.0, 1.0);
    CHECK(std::hypot(before.x - after.x, before.y - after.y) < 0.5F);
    CHECK(to_pixel(tilted, 0.0, 0.0, 1.0).y < to_pixel(tilted, 0.0, 0.0, 0.4).y - 30.0F);
    CHECK(same(to_pixel(flat, 1.0, 2.0, 1.0), to_pixel(flat, 1.0, 2.0, 0.0)));
}

// V(r) = v (1.5 / r)^2: a quarter at twice the hot zone's radius.
TEST_CASE("receptor view: the wave's amplitude is a quarter at 3 mm") {
    const Example e(Receptor::meissner, 6.0);
    ReceptorScene scene = e.scene();
    scene.quantity = ReceptorQuantity::amplitude;
    CHECK(std::abs(shown_value(scene, 3.0) - 0.25) <= 1e-12);
}

TEST_CASE("receptor view: hundreds of receptors, all firing, cost a few quads each") {
    const Example e(Receptor::meissner, 12.0);
    const auto n = static_cast<int>(e.grid.receptors.size());
    REQUIRE(n > 600);
    const std::vector<float> flash(e.grid.receptors.size(), 1.0F);
    ReceptorScene scene = e.scene();
    scene.half_extent_mm = 12.5;
    scene.flash = flash;
    // A mark and its glow; words, fingertip and circles are a few thousand.
    CHECK(drawn(scene).vertices <= 8 * n + 4'000);
}

TEST_CASE("receptor view: an area without room draws nothing and does not fail") {
    const Example e(Receptor::meissner, 5.0);
    for (const ImVec2 size : {ImVec2{0, 0}, {1, 50}, {50, 1}, {7, 7}, {12, 12}}) {
        const Rect area = rect_at({10, 10}, size);
        const Drawn d = drawn(e.scene(), {}, area);
        CHECK(count_strays(d.image, area, dark_theme(1.0F).pane) == 0);
    }
}

// The model may share impulses so that a receptor fires several times its rate by Eq. 2: the text
// first tells the number that a student counts in the raster.
TEST_CASE("receptor view: the number in the caption is the number of spikes in the raster") {
    std::vector<double> fractions(100);
    for (std::size_t i = 0; i < fractions.size(); ++i) {
        fractions[i] = static_cast<double>((i + 1) * (i + 1)) / 1e4;
    }
    for (const double factor : {0.2, 1.8}) {
        const Example e(Receptor::pacinian, 6.0);
        const std::vector<std::vector<int>> train{
            spike_counts(fractions, factor * e.activation.rate_hz, WindowSplit::halves)};
        const std::array<RasterChannel, 1> channels{{{Receptor::pacinian, train, {}}}};
        int seen = 0;
        for (double from_s = 0.0; from_s < 0.95; from_s += 0.2) {
            RasterLayout layout;
            const Image image = draw_picture(2020, 60, {}, [&](const Theme& theme) {
                const RasterScene scene{.channels = channels,
                                        .start_s = from_s,
                                        .end_s = from_s + 0.2,
                                        .names_px = 0.0F,
                                        .time_axis = false,
                                        .rates = false};
                const Rect area{{10, 10}, {2010, 50}};
                draw_raster("raster", theme, area, scene);
                layout = raster_layout(theme, area, scene);
            });
            const int y = static_cast<int>(layout.bands[0].rows.centre().y);
            const ImU32 hue = dark_theme(1.0F).receptor[1];
            for (int x = 10; x < 2010; ++x) {
                seen += pixel(image, x, y) == hue && pixel(image, x - 1, y) != hue ? 1 : 0;
            }
        }
        ReceptorScene scene = e.scene();
        scene.centre_spikes = std::accumulate(train[0].begin(), train[0].end(), 0);
        scene.duration_s = 1.0;
        CHECK(seen == *scene.centre_spikes);
        CHECK(centre_hz(scene) == seen);
        draw_picture(100, 100, {}, [&](const Theme& theme) {
            const ImFont* font = theme.fonts.small;
            const std::string count = std::to_string(seen);
            CHECK(receptor_state_text(scene, font, 1000.0F) ==
                  "centre fires " + count + " in 1 s (rate by Eq. 2: 190 imp/s), as far as 6.0 mm");
            CHECK(receptor_state_text(scene, font, 100.0F) == "fires " + count + " in 1 s");
        });
    }
}

TEST_CASE("receptor view: colour and height go by what fires where that is known") {
    const Example e(Receptor::meissner, 5.0);
    ReceptorScene scene = e.scene();
    scene.largest_hz = 400.0;
    CHECK(shown_value(scene, 0.0) == doctest::Approx(190.0 / 400.0));
    scene.centre_spikes = 300;
    scene.duration_s = 1.5;
    CHECK(shown_value(scene, 0.0) == doctest::Approx(0.5));
    CHECK(shown_value(scene, 3.0) == doctest::Approx(0.5 * rate_at_hz(e.activation, 3.0) / 190.0));
    scene.centre_spikes = 0;
    CHECK(shown_value(scene, 0.0) == 0.0);
}

}  // namespace tact::receptor_view_test
