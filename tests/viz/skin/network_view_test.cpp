#include "viz/skin/network_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/drawn_view.h"
#include "tests/support/headless_window.h"
#include "tests/support/presence.h"
#include "viz/skin/network_caption.h"

namespace tact::network_view_test {
namespace {

const Rect kArea{{10, 10}, {650, 210}};

// `spikes` at every place within `half` of the centre, through the default network.
struct Example {
    std::vector<RelayLayer> layers;
    std::vector<std::string> names{"spikes"};

    Example(int half, double spikes, int excitatory = 3, int inhibitory = 1) {
        RelayLayer first = empty_layer(half);
        std::ranges::fill(first.cells, spikes);
        NeuralCodingParams params;
        params.excitatory_layers = excitatory;
        params.inhibitory_layers = inhibitory;
        layers = relay(first, params, false);
        layers.insert(layers.begin(), first);
        for (std::size_t k = 1; k < layers.size(); ++k) {
            names.push_back("layer " + std::to_string(k));
        }
    }
    NetworkScene scene() const { return {.layers = layers, .names = names}; }
};

using Drawn = DrawnView<NetworkAction, NetworkLayout>;

Drawn drawn(const NetworkScene& scene, const PictureOptions& options = {},
            const Rect& area = kArea) {
    return drawn_view<NetworkAction, NetworkLayout>(
        options, area,
        [&](const Theme& theme) { return draw_network("network", theme, area, scene); },
        [&](const Theme& theme) { return network_layout(theme, area, scene); });
}

ImVec2 middle_of(const NetworkLayout& layout, const NetworkScene& scene, const NetworkCell& cell) {
    const int half = scene.layers[cell.layer].half_width;
    return layout.maps[cell.layer].min +
           ImVec2{(static_cast<float>(cell.column + half) + 0.5F) * layout.cell_px,
                  (static_cast<float>(cell.row + half) + 0.5F) * layout.cell_px};
}

ImU32 colour_at(const Image& image, ImVec2 at) {
    return pixel(image, static_cast<int>(at.x), static_cast<int>(at.y));
}

}  // namespace

TEST_CASE("network view: every excitatory layer is a cell wider on each side, inhibitory not") {
    const Example e(2, 1.0);
    const Drawn d = drawn(e.scene());
    REQUIRE(d.layout.maps.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(kArea.contains(d.layout.maps[k]));
        const auto cells = static_cast<float>(2 * (2 + std::min<std::size_t>(k, 3)) + 1);
        CHECK(d.layout.maps[k].width() == cells * d.layout.cell_px);
        CHECK(d.layout.maps[k].height() == d.layout.maps[k].width());
    }
}

TEST_CASE("network view: a cell has the colour of its value") {
    Example e(2, 0.0);
    // A corner of the first layer: no outline, no ring there.
    e.layers[0].cell(-2, 2) = 12.5;
    e.layers[0].cell(2, -2) = 3.0;
    const NetworkScene scene = e.scene();
    const Drawn d = drawn(scene);
    // Away from the middle of the cell, where a dot would be.
    const ImVec2 off{0.25F * d.layout.cell_px, 0.25F * d.layout.cell_px};
    const auto seen = [&](int column, int row) {
        return colour_at(d.image, middle_of(d.layout, scene, {0, column, row}) + off);
    };
    CHECK(seen(-2, 2) == activity_colour(12.5, 50.0));
    CHECK(seen(2, -2) == activity_colour(3.0, 50.0));
    CHECK(seen(2, 2) == activity_colour(0.0, 50.0));
}

TEST_CASE("network view: colours tell a single spike from none and the cap from less") {
    CHECK(activity_colour(1.0, 50.0) != activity_colour(0.0, 50.0));
    CHECK(activity_colour(49.0, 50.0) != activity_colour(50.0, 50.0));
    CHECK(activity_colour(60.0, 50.0) == activity_colour(50.0, 50.0));
    CHECK(activity_colour(5.0, 0.0) == activity_colour(0.0, 50.0));
}

TEST_CASE("network view: cells at the cap are marked, large ones and small ones") {
    for (const int half : {2, 30}) {
        Example full(half, 50.0, 1, 0);
        Example less(half, 49.5, 1, 0);
        // In the light theme only the seams between large cells are as dark.
        const Drawn at_cap = drawn(full.scene(), {.dark = false});
        const Drawn below = drawn(less.scene(), {.dark = false});
        // Above the outlined diamond: the mark differs (and the colour, by a little).
        const auto dark = [&](const Drawn& d) {
            Rect top = d.layout.maps[0];
            top.max.y = top.min.y + 0.15F * top.height();
            return count_pixels(d.image, top, IM_COL32_BLACK, 110);
        };
        if (half == 30) CHECK(dark(below) == 0);
        CHECK(dark(at_cap) >= dark(below) + (half == 2 ? 3 : 60));
    }
}

// On a light background, gaps would hide the white outline.
TEST_CASE("network view: seams between cells are darker than any cell, in either theme") {
    const Example e(2, 50.0);
    for (const bool is_dark : {true, false}) {
        const Drawn d = drawn(e.scene(), {.dark = is_dark});
        REQUIRE(d.layout.cell_px >= 10.0F);
        const ImU32 pane = is_dark ? dark_theme(1.0F).pane : light_theme(1.0F).pane;
        Rect top = inset(d.layout.maps[4], 1.0F);
        top.max.y = top.min.y + 0.3F * top.height();  // above the ring around the centre
        CHECK(count_pixels(d.image, top, pane) == 0);
        CHECK(count_pixels(d.image, top, IM_COL32(31, 0, 38, 255), 6) > 50);
    }
}

TEST_CASE("network view: in a low and wide area words stand beside maps that have its height") {
    const Example e(8, 1.0);
    const Rect area{{10, 10}, {1210, 100}};
    NetworkScene scene = e.scene();
    scene.legend = false;
    const Drawn d = drawn(scene, {}, area);
    REQUIRE(d.layout.beside);
    CHECK(d.layout.maps[4].height() > 0.7F * area.height());
    const ImU32 dim = dark_theme(1.0F).dim_text;
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(d.layout.captions[k].min.x >= d.layout.maps[k].max.x);
        CHECK(area.contains(d.layout.captions[k]));
        if (k == 0) continue;
        const Rect between{{d.layout.captions[k - 1].max.x, area.min.y},
                           {d.layout.maps[k].min.x, area.max.y}};
        CHECK(count_pixels(d.image, between, dim, 20) > 100);  // an arrow
    }
    CHECK_FALSE(drawn(e.scene()).layout.beside);
}

// A cell moves one place per layer: of five layers the first has four moves left, the last none.
TEST_CASE("network view: the ring around the centre stays in its map, of one cell, too") {
    const Example e(0, 0.0);
    const Drawn d = drawn(e.scene(), {}, {{10, 10}, {1210, 210}});
    const Rect& map = d.layout.maps.front();
    REQUIRE(d.layout.cell_px > 20.0F);
    const Rect beside{{map.min.x - 0.3F * d.layout.cell_px, map.min.y},
                      {map.min.x - 2.0F, map.max.y}};
    CHECK(count_pixels(d.image, beside, IM_COL32_WHITE, 200) == 0);
    CHECK(count_pixels(d.image, map, IM_COL32_WHITE, 200) > 20);
}

TEST_CASE("network view: the cone is the diamond of cells that can still reach the centre") {
    const Example e(6, 1.0);
    const NetworkScene scene = e.scene();
    CHECK(reaches_centre(scene, {0, 4, 0}));
    CHECK(reaches_centre(scene, {0, -2, 2}));
    CHECK_FALSE(reaches_centre(scene, {0, 3, 2}));
    CHECK_FALSE(reaches_centre(scene, {3, 1, 1}));
    CHECK(reaches_centre(scene, {4, 0, 0}));
    CHECK_FALSE(reaches_centre(scene, {4, 0, 1}));
    const Drawn d = drawn(scene);
    // Its outline passes between the fourth and the fifth cell from the centre.
    const auto white_near = [&](int column) {
        const ImVec2 middle = middle_of(d.layout, scene, {0, column, 0});
        const Rect cell{middle - ImVec2{0.5F, 0.5F} * d.layout.cell_px,
                        middle + ImVec2{0.5F, 0.5F} * d.layout.cell_px};
        return count_pixels(d.image, cell, IM_COL32_WHITE, 40);
    };
    CHECK(white_near(4) > 2);
    CHECK(white_near(5) == 0);
}

TEST_CASE("network view: the mouse over a cell names its layer, column and row") {
    const Example e(3, 2.0);
    const NetworkScene scene = e.scene();
    for (const float scale : {1.0F, 2.0F}) {
        const Rect area{kArea.min * scale, kArea.max * scale};
        const Drawn quiet = drawn(scene, {.scale = scale}, area);
        CHECK_FALSE(quiet.action.hovered.has_value());
        for (const NetworkCell& cell : {NetworkCell{0, -3, 3}, {1, 0, 0}, {3, 6, -6}, {4, -2, 5}}) {
            const ImVec2 mouse = middle_of(quiet.layout, scene, cell);
            const Drawn d = drawn(scene, {.scale = scale, .mouse_px = mouse}, area);
            REQUIRE(d.action.hovered.has_value());
            CHECK(d.action.hovered->layer == cell.layer);
            CHECK(d.action.hovered->column == cell.column);
            CHECK(d.action.hovered->row == cell.row);
            CHECK_FALSE(d.action.clicked.has_value());
        }
    }
}

TEST_CASE("network view: a click names the cell, between the maps there is none") {
    const Example e(3, 2.0);
    const NetworkScene scene = e.scene();
    const Theme theme = dark_theme(1.0F);
    HeadlessWindow window;
    std::optional<NetworkCell> clicked;
    NetworkLayout layout;
    const auto draw = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({700, 400});
        ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration);
        const NetworkAction now = draw_network("network", theme, kArea, scene);
        layout = network_layout(theme, kArea, scene);
        if (now.clicked) clicked = now.clicked;
        ImGui::End();
    };
    window.settle(draw);
    const ImVec2 between{(layout.maps[0].max.x + layout.maps[1].min.x) / 2.0F,
                         layout.maps[0].centre().y};
    window.click(between);
    window.settle(draw);
    CHECK_FALSE(clicked.has_value());
    window.click(middle_of(layout, scene, {2, 1, -4}));
    window.settle(draw);
    CHECK(clicked == NetworkCell{2, 1, -4});
}

TEST_CASE("network view: a step without spikes says so under its dark maps") {
    const Example silent(2, 0.0);
    const Drawn d = drawn(silent.scene());
    const Rect last = d.layout.maps.back();
    CHECK(count_pixels(d.image, last, activity_colour(0.0, 50.0)) >
          0.7F * last.width() * last.height());
    const Theme theme = dark_theme(1.0F);
    CHECK(count_pixels(d.image, d.layout.legend, theme.dim_text, 40) > 30);
    // No colour scale if there is no value to read with it.
    CHECK(count_pixels(d.image, d.layout.legend, activity_colour(50.0, 50.0), 30) == 0);
    const Drawn active = drawn(Example(2, 1.0).scene());
    CHECK(count_pixels(active.image, active.layout.legend, activity_colour(50.0, 50.0), 30) > 5);
}

TEST_CASE("network view: before anything was computed it says so") {
    const Drawn d = drawn({});
    CHECK(count_pixels(d.image, kArea, dark_theme(1.0F).text, 30) > 50);
    CHECK_FALSE(d.action.hovered.has_value());
}

TEST_CASE("network view: stale layers step back") {
    const Example e(2, 50.0);
    NetworkScene scene = e.scene();
    const ImU32 full = activity_colour(50.0, 50.0);
    const Drawn fresh = drawn(scene);
    scene.stale = true;
    const Drawn stale = drawn(scene);
    CHECK(count_pixels(fresh.image, fresh.layout.maps[1], full) > 100);
    CHECK(count_pixels(stale.image, stale.layout.maps[1], full) == 0);
}

TEST_CASE("network view: maps go into rows where that makes their cells larger") {
    const Example e(8, 1.0);
    const Drawn wide = drawn(e.scene());
    const Drawn tall = drawn(e.scene(), {}, {{10, 10}, {210, 610}});
    CHECK(wide.layout.maps[4].centre().y == wide.layout.maps[0].centre().y);
    CHECK(tall.layout.maps[4].min.y > tall.layout.maps[0].max.y);
    // Five in one row of 200 px would have cells of 200 / 5 / 23.
    CHECK(tall.layout.cell_px > 200.0F / 5.0F / 23.0F);
}

TEST_CASE("network view: maps and words stay inside the area, however narrow" *
          doctest::test_suite("long")) {
    for (const int half : {0, 5, 20}) {
        Example e(half, 3.0, 4, 4);
        e.names.back() = "a layer with a long name that fits nowhere";
        NetworkScene scene = e.scene();
        scene.pointed = NetworkCell{0, half, -half};
        for (const float scale : {1.0F, 2.0F}) {
            for (const ImVec2 size : {ImVec2{640, 200}, {300, 70}, {90, 300}, {40, 40}, {9, 9}}) {
                const Rect area = rect_at({10.0F, 10.0F}, size * scale);
                const Drawn d = drawn(scene, {.scale = scale}, area);
                CHECK(count_strays(d.image, area, dark_theme(scale).pane) == 0);
                for (const Rect& map : d.layout.maps) CHECK(inset(area, -1.0F).contains(map));
            }
        }
    }
}

TEST_CASE("network view: cost is bounded by the cells") {
    const Example e(17, 3.0, 4, 4);
    std::size_t cells = 0;
    for (const RelayLayer& layer : e.layers) cells += layer.cells.size();
    // One quad and at most one mark per cell; words, outlines and rings take a few thousand.
    CHECK(drawn(e.scene()).vertices <= static_cast<int>(8 * cells) + 6'000);
}

}  // namespace tact::network_view_test
