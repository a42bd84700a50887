#include "viz/skin/raster_view.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "model/physiology/spike_train.h"
#include "tests/support/drawn_view.h"
#include "tests/support/headless_window.h"
#include "tests/support/presence.h"
#include "viz/skin/raster_cells.h"

namespace tact::raster_view_test {
namespace {

using Counts = std::vector<std::vector<int>>;

const Rect kArea{{10, 10}, {590, 290}};

// Receptor r fires one spike in step s if (s + r) is a multiple of `every`; 0: never.
Counts counts_of(std::size_t receptors, std::size_t steps, std::size_t every) {
    Counts result(receptors, std::vector<int>(steps, 0));
    for (std::size_t r = 0; r < receptors; ++r) {
        for (std::size_t s = 0; s < steps; ++s) {
            if (every > 0 && (s + r) % every == 0) result[r][s] = 1;
        }
    }
    return result;
}

struct Example {
    std::array<Counts, kReceptorCount> counts{counts_of(641, 200, 3), counts_of(80, 200, 2),
                                              counts_of(1, 200, 0), counts_of(9, 200, 5)};
    std::vector<RasterChannel> channels;

    Example() {
        for (const Receptor receptor : kReceptors) {
            channels.push_back({receptor, counts[index_of(receptor)], {}});
        }
    }
    Example(const Example&) = delete;
    Example& operator=(const Example&) = delete;
};

using Drawn = DrawnView<RasterAction, RasterLayout>;

Drawn drawn(const RasterScene& scene, const PictureOptions& options = {},
            const Rect& area = kArea) {
    return drawn_view<RasterAction, RasterLayout>(
        options, area,
        [&](const Theme& theme) { return draw_raster("raster", theme, area, scene); },
        [&](const Theme& theme) { return raster_layout(theme, area, scene); });
}

// Runs of drawn pixels along a row of the picture.
int runs_along(const Image& image, float y, float from, float to, ImU32 ground) {
    int runs = 0;
    bool inside = false;
    for (int x = static_cast<int>(from); x < static_cast<int>(to); ++x) {
        const bool drawn_here = pixel(image, x, static_cast<int>(y)) != ground;
        if (drawn_here && !inside) ++runs;
        inside = drawn_here;
    }
    return runs;
}

}  // namespace

TEST_CASE("raster: squeezing rows and steps loses no spike and counts none twice") {
    const Counts counts = counts_of(641, 203, 7);
    const RasterChannel channel{Receptor::meissner, counts, {}};
    int all = 0;
    for (const auto& row : counts) all += std::accumulate(row.begin(), row.end(), 0);
    for (const std::size_t rows : {1U, 10U, 75U, 641U}) {
        for (const std::size_t columns : {1U, 50U, 202U, 203U}) {
            const std::vector<int> sums = binned(channel, {0, 203, columns, 0, 641, rows});
            REQUIRE(sums.size() == rows * columns);
            CHECK(std::accumulate(sums.begin(), sums.end(), 0) == all);
        }
    }
}

TEST_CASE("raster: a block holds the spikes of its own receptors and steps, in drawing order") {
    Counts counts(4, std::vector<int>(6, 0));
    counts[2][5] = 3;
    counts[0][0] = 2;
    const std::vector<std::size_t> order{2, 1, 3, 0};
    const RasterChannel channel{Receptor::merkel, counts, order};
    CHECK(binned(channel, {0, 6, 2, 0, 4, 2}) == std::vector<int>{0, 3, 2, 0});
    CHECK(binned(channel, {5, 6, 1, 0, 1, 1}) == std::vector<int>{3});
}

TEST_CASE("raster: a column is pale where all of its steps are") {
    const Counts counts(1, std::vector<int>(6, 1));
    const std::vector<char> pale{0, 0, 0, 1, 1, 1};
    RasterChannel channel{Receptor::merkel, counts, {}};
    CHECK_FALSE(is_pale(channel, {0, 6, 6, 0, 1, 1}, 5));
    channel.pale_steps = pale;
    CHECK_FALSE(is_pale(channel, {0, 6, 6, 0, 1, 1}, 2));
    CHECK(is_pale(channel, {0, 6, 6, 0, 1, 1}, 3));
    CHECK_FALSE(is_pale(channel, {0, 6, 3, 0, 1, 1}, 1));
    CHECK(is_pale(channel, {0, 6, 3, 0, 1, 1}, 2));
}

TEST_CASE("raster: pale steps have none of the colour that others have") {
    Example e;
    const std::vector<char> pale(200, 1);
    const Drawn full = drawn({.channels = e.channels});
    for (RasterChannel& channel : e.channels) channel.pale_steps = pale;
    const Drawn paler = drawn({.channels = e.channels});
    const Rect& rows = full.layout.bands[0].rows;
    const auto lit = [&](const Image& image) {
        long sum = 0;
        for (int y = static_cast<int>(rows.min.y); y < static_cast<int>(rows.max.y); ++y) {
            for (int x = static_cast<int>(rows.min.x); x < static_cast<int>(rows.max.x); ++x) {
                const ImU32 here = pixel(image, x, y);
                for (int shift = 0; shift < 24; shift += 8) sum += (here >> shift) & 255U;
            }
        }
        return sum;
    };
    CHECK(lit(paler.image) < lit(full.image));
}

TEST_CASE("raster: totals are sums over receptors") {
    Counts counts(3, std::vector<int>(2, 1));
    counts[1][1] = 4;
    const RasterTotals all = totals({Receptor::merkel, counts, {}});
    CHECK(all.per_step == std::vector<int>{3, 6});
    CHECK(all.largest_count == 4);
    CHECK(all.largest_total == 6);
}

TEST_CASE("raster: every firing type shows in its colour, a silent one says so") {
    const Example e;
    for (const bool dark : {true, false}) {
        const Drawn d = drawn({.channels = e.channels}, {.dark = dark});
        const Theme theme = dark ? dark_theme(1.0F) : light_theme(1.0F);
        for (const Receptor receptor : kReceptors) {
            const std::size_t c = index_of(receptor);
            const RasterBand& band = d.layout.bands[c];
            const bool fires = receptor != Receptor::merkel;
            CHECK(band.fires == fires);
            // The line on top of the rate has the full colour.
            CHECK((count_pixels(d.image, band.rate, theme.receptor[c], 2) > 50) == fires);
            if (!fires) continue;
            const float area = band.rows.width() * band.rows.height();
            CHECK(count_pixels(d.image, band.rows, theme.pane) < 0.9F * area);
        }
        const Rect silent = d.layout.bands[index_of(Receptor::merkel)].rows;
        CHECK(count_pixels(d.image, silent, theme.dim_text, 60) > 10);
    }
}

TEST_CASE("raster: more spikes are stronger, none leave the ground") {
    Counts counts(2, std::vector<int>(2, 0));
    counts[0] = {4, 1};
    const std::array<RasterChannel, 1> channels{{{Receptor::pacinian, counts, {}}}};
    const Drawn d =
        drawn({.channels = channels, .end_s = 0.01, .rates = false}, {}, {{10, 10}, {120, 100}});
    const Theme theme = dark_theme(1.0F);
    const Rect rows = d.layout.bands[0].rows;
    // The first row has four spikes, then one; the second row has none.
    const float middle = rows.centre().x;
    const float y = rows.min.y + 0.25F * rows.height();
    const ImU32 pane = theme.pane;
    CHECK(runs_along(d.image, y, rows.min.x, middle - 1.0F, pane) == 4);
    CHECK(runs_along(d.image, y, middle - 1.0F, rows.max.x, pane) == 1);
    CHECK(runs_along(d.image, y + 0.5F * rows.height(), rows.min.x, rows.max.x, pane) == 0);
}

TEST_CASE("raster: zoomed to one step, n spikes are n ticks where the model puts them") {
    for (const int n : {1, 2, 5}) {
        const Counts counts(1, std::vector<int>{n, 0});
        const std::array<RasterChannel, 1> channels{{{Receptor::pacinian, counts, {}}}};
        const Drawn d = drawn({.channels = channels, .end_s = 0.01, .rates = false});
        const Rect rows = d.layout.bands[0].rows;
        const ImU32 pane = dark_theme(1.0F).pane;
        CHECK(runs_along(d.image, rows.centre().y, rows.min.x, rows.max.x, pane) == n);
        for (const std::size_t offset : spread_spikes(n)) {
            // Samples of 0.1 ms.
            const float x = to_pixel(d.layout.plot.x, static_cast<double>(offset) * 1e-4);
            const Rect near{{std::round(x), rows.min.y}, {std::round(x) + 1.0F, rows.max.y}};
            CHECK(count_pixels(d.image, near, dark_theme(1.0F).receptor[1], 2) > 0);
        }
    }
}

TEST_CASE("raster: spikes stand at their time whatever the zoom") {
    Counts counts(1, std::vector<int>(200, 0));
    counts[0][120] = 1;  // 0.600 to 0.605 s
    const std::array<RasterChannel, 1> channels{{{Receptor::pacinian, counts, {}}}};
    for (const auto& [start_s, end_s] : {std::pair{0.0, 1.0}, {0.5, 0.7}, {0.598, 0.61}}) {
        const Drawn d = drawn({.channels = channels, .start_s = start_s, .end_s = end_s});
        const float from = to_pixel(d.layout.plot.x, 0.6) - 1.0F;
        const float to = to_pixel(d.layout.plot.x, 0.605) + 1.0F;
        const Rect rows = d.layout.bands[0].rows;
        const ImU32 hue = dark_theme(1.0F).receptor[1];
        const int all = count_pixels(d.image, rows, hue, 2);
        CHECK(all > 0);
        CHECK(count_pixels(d.image, {{from, rows.min.y}, {to, rows.max.y}}, hue, 2) == all);
    }
}

TEST_CASE("raster: the mouse over a row names its receptor and the time, in any order of rows") {
    const Example e;
    std::vector<std::size_t> order(80);
    std::iota(order.rbegin(), order.rend(), std::size_t{0});
    std::vector<RasterChannel> channels = e.channels;
    channels[1].order = order;
    const RasterScene scene{.channels = channels};
    for (const float scale : {1.0F, 2.0F}) {
        const Rect area{kArea.min * scale, kArea.max * scale};
        const Drawn quiet = drawn(scene, {.scale = scale}, area);
        CHECK_FALSE(quiet.action.hovered.has_value());
        const RasterBand& band = quiet.layout.bands[1];
        const float row = 10.5F;
        const ImVec2 mouse{to_pixel(quiet.layout.plot.x, 0.5),
                           std::floor(band.rows.min.y + row * band.row_px)};
        const Drawn d = drawn(scene, {.scale = scale, .mouse_px = mouse}, area);
        REQUIRE(d.action.hovered.has_value());
        CHECK(d.action.hovered->channel == 1);
        // The mouse moves by whole pixels, which limits the rows it can tell apart.
        const double rows = std::ceil(1.0 / static_cast<double>(band.row_px));
        CHECK(std::abs(static_cast<double>(d.action.hovered->receptor) - 69.0) <= rows);
        REQUIRE(d.action.hovered_s.has_value());
        CHECK(std::abs(*d.action.hovered_s - 0.5) < 0.01);
        CHECK_FALSE(d.action.scrubbed_s.has_value());
    }
}

TEST_CASE("raster: pressing scrubs, and a click also names the row") {
    const Example e;
    const RasterScene scene{.channels = e.channels};
    Theme theme = dark_theme(1.0F);
    HeadlessWindow window;
    RasterAction seen;
    RasterLayout layout;
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({700, 400});
        ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration);
        // Cells of 641 rows need more vertices than a draw command without offsets can address.
        ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        const RasterAction now = draw_raster("raster", theme, kArea, scene);
        layout = raster_layout(theme, kArea, scene);
        if (now.clicked) seen.clicked = now.clicked;
        if (now.scrubbed_s) seen.scrubbed_s = now.scrubbed_s;
        ImGui::End();
    };
    window.settle(draw);
    const RasterBand& band = layout.bands[3];
    const ImVec2 at{std::floor(to_pixel(layout.plot.x, 0.25)),
                    std::floor(band.rows.min.y + 2.5F * band.row_px)};
    window.move(at);
    window.settle(draw);
    CHECK_FALSE(seen.scrubbed_s.has_value());
    window.click(at);
    window.settle(draw);
    REQUIRE(seen.clicked.has_value());
    CHECK(seen.clicked->channel == 3);
    CHECK(seen.clicked == spot_at(layout, scene, at));
    REQUIRE(seen.scrubbed_s.has_value());
    CHECK(std::abs(*seen.scrubbed_s - 0.25) < 0.01);
}

TEST_CASE("raster: the selected row and the playhead stand out across the view") {
    const Example e;
    const ImU32 accent = dark_theme(1.0F).accent;
    RasterScene scene{.channels = e.channels};
    const Drawn plain = drawn(scene);
    scene.selected = RasterSpot{1, 40};
    const Drawn selected = drawn(scene);
    const Rect rows = plain.layout.bands[1].rows;
    CHECK(count_pixels(selected.image, rows, accent, 2) >=
          static_cast<int>(2.0F * rows.width()) - 4);
    CHECK(count_pixels(plain.image, rows, accent, 2) == 0);
    scene.selected.reset();
    scene.playhead_s = 0.5;
    const float x = std::round(to_pixel(plain.layout.plot.x, 0.5) - 0.5F);
    CHECK(count_pixels(drawn(scene).image, {{x, rows.min.y}, {x + 1.0F, rows.max.y}}, accent, 2) ==
          static_cast<int>(rows.height()));
}

TEST_CASE("raster: a given width for names puts the time axis there") {
    const Example e;
    const Drawn d = drawn({.channels = e.channels, .names_px = 120.0F});
    CHECK(d.layout.plot.area.min.x == kArea.min.x + 120.0F);
}

TEST_CASE("raster: stale spikes step back") {
    const Example e;
    const ImU32 hue = dark_theme(1.0F).receptor[0];
    const Drawn fresh = drawn({.channels = e.channels});
    const Drawn stale = drawn({.channels = e.channels, .stale = true});
    const Rect rate = fresh.layout.bands[0].rate;
    CHECK(count_pixels(fresh.image, rate, hue, 2) > 100);
    CHECK(count_pixels(stale.image, rate, hue, 2) == 0);
}

TEST_CASE("raster: before anything was computed it says so") {
    const Drawn d = drawn({});
    CHECK(count_pixels(d.image, kArea, dark_theme(1.0F).text, 30) > 50);
    CHECK_FALSE(d.action.hovered.has_value());
}

TEST_CASE("raster: rows and words stay inside the area, however small") {
    const Example e;
    for (const float scale : {1.0F, 2.0F}) {
        for (const ImVec2 size : {ImVec2{580, 280}, {300, 60}, {120, 200}, {60, 40}, {8, 8}}) {
            const Rect area = rect_at({10.0F, 10.0F}, size * scale);
            const Drawn d =
                drawn({.channels = e.channels, .selected = RasterSpot{0, 640}, .playhead_s = 1.0},
                      {.scale = scale}, area);
            CHECK(count_strays(d.image, area, dark_theme(scale).pane) == 0);
        }
    }
}

TEST_CASE("raster: receptors that fire alike cost no more than one of them") {
    // 640 equal rows: a few quads for each step, and some hundreds for words.
    const Counts counts(640, counts_of(1, 200, 2).front());
    const std::array<RasterChannel, 1> channels{{{Receptor::meissner, counts, {}}}};
    CHECK(drawn({.channels = channels}).vertices <= 4 * 3 * 200 + 1'500);
}

TEST_CASE("raster: times before and after the signal are empty") {
    const Example e;
    const Drawn d = drawn({.channels = e.channels, .start_s = 2.0, .end_s = 3.0});
    const Rect rows = d.layout.bands[0].rows;
    const ImU32 pane = dark_theme(1.0F).pane;
    for (const float part : {0.1F, 0.5F, 0.9F}) {
        const float y = rows.min.y + part * rows.height();
        CHECK(runs_along(d.image, y, rows.min.x, rows.max.x, pane) == 0);
    }
}

}  // namespace tact::raster_view_test
