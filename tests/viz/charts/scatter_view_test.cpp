#include "viz/charts/scatter_view.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/headless_window.h"
#include "tests/support/presence.h"
#include "viz/drawing/colour.h"
#include "viz/picture/picture.h"

namespace scatter_view_test {

using namespace tact;

namespace {

const Rect kArea{{0.0F, 0.0F}, {400.0F, 300.0F}};

ScatterScene scene_of(const std::vector<double>& x, const std::vector<double>& y) {
    ScatterScene scene;
    scene.x = x;
    scene.y = y;
    scene.x_title = "rank";
    scene.y_title = "rated";
    return scene;
}

// The action of one frame with the mouse at a place, pressed and released there.
ScatterAction clicked(const ScatterScene& scene, ImVec2 at) {
    HeadlessWindow window;
    const Theme theme = dark_theme(1.0F);
    ScatterAction seen;
    const auto frame = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({420, 320});
        ImGui::Begin("w", nullptr, ImGuiWindowFlags_NoDecoration);
        const ScatterAction action = draw_scatter("s", theme, kArea, scene);
        if (action.hovered) seen.hovered = action.hovered;
        if (action.clicked) seen.clicked = action.clicked;
        ImGui::End();
    };
    window.settle(frame);
    window.click(at);
    window.settle(frame);
    return seen;
}

// The place of a point, in a frame with fonts.
ImVec2 place(const ScatterScene& scene, std::size_t index) {
    HeadlessWindow window;
    const Theme theme = dark_theme(1.0F);
    ImVec2 at{0, 0};
    window.frame([&] { at = scatter_point(theme, kArea, scene, index); });
    return at;
}

// Pairs in no order, with a stepped fit: `level` pairs share each step.
struct Pairs {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> fitted;

    Pairs(std::size_t count, std::size_t level) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t place = k * 7919 % count;  // every place once: 7919 is prime
            x.push_back(1.0 + 0.01 * static_cast<double>(place));
            fitted.push_back(std::sqrt(static_cast<double>(place / level)));
            y.push_back(fitted.back() + (k % 3 == 0 ? 0.2 : -0.1));
        }
    }
    ScatterScene scene() const {
        ScatterScene scene = scene_of(x, y);
        scene.fitted = fitted;
        return scene;
    }
};

struct DrawnFit {
    std::vector<ImVec2> line;   // the corners that are drawn
    std::vector<ImVec2> whole;  // every pair's place on the fit, in order of x
    float left = 0.0F;
    float right = 0.0F;
};

DrawnFit fit_of(const Pairs& pairs) {
    HeadlessWindow window;
    const Theme theme = dark_theme(1.0F);
    const ScatterScene scene = pairs.scene();
    ScatterScene on_fit = scene;  // points at the fit, on the same axes
    const ScatterSummary summary = summary_of(pairs.x, pairs.y, pairs.fitted);
    on_fit.y = pairs.fitted;
    on_fit.summary = &summary;
    DrawnFit result;
    window.frame([&] {
        result.line = scatter_fit_line(theme, kArea, scene);
        for (std::size_t k = 0; k < pairs.x.size(); ++k) {
            result.whole.push_back(scatter_point(theme, kArea, on_fit, k));
        }
    });
    std::ranges::stable_sort(result.whole,
                             [](ImVec2 a, ImVec2 b) { return a.x != b.x ? a.x < b.x : a.y > b.y; });
    return result;
}

// The distance of the drawn line from the fit at a pair: the largest within the pixel column around
// it.
float farthest_px(const DrawnFit& fit) {
    float farthest = 0.0F;
    std::size_t k = 0;
    for (const ImVec2& pair : fit.whole) {
        while (k + 1 < fit.line.size() && fit.line[k + 1].x < pair.x - 1.0F) ++k;
        float highest = -1e9F;
        float lowest = 1e9F;
        for (std::size_t i = k; i < fit.line.size() && fit.line[i].x <= pair.x + 1.0F; ++i) {
            highest = std::max(highest, fit.line[i].y);
            lowest = std::min(lowest, fit.line[i].y);
        }
        farthest = std::max({farthest, pair.y - highest, lowest - pair.y});
    }
    return farthest;
}

// The corners in one frame with a view of these pairs.
struct Cost {
    int vertices = 0;
    int most_in_a_command = 0;
};

Cost cost_of(const ScatterScene& scene, ImVec2 size) {
    HeadlessWindow window;
    ImGui::GetIO().DisplaySize = size;
    const Theme theme = dark_theme(1.0F);
    Cost cost;
    const auto frame = [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("w", nullptr, ImGuiWindowFlags_NoDecoration);
        draw_scatter("s", theme, {{0, 0}, size}, scene);
        const ImDrawList& list = *ImGui::GetWindowDrawList();
        cost = {list.VtxBuffer.Size, 0};
        for (const ImDrawCmd& command : list.CmdBuffer) {
            for (unsigned i = 0; i < command.ElemCount; ++i) {
                const int index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
                cost.most_in_a_command = std::max(cost.most_in_a_command, index);
                CHECK(static_cast<int>(command.VtxOffset) + index < list.VtxBuffer.Size);
            }
        }
        ImGui::End();
    };
    window.settle(frame);
    return cost;
}

}  // namespace

TEST_CASE("scatter: a click takes the point under the mouse, beside all points none") {
    const std::vector<double> x{1.0, 2.0, 3.0, 4.0};
    const std::vector<double> y{10.0, 40.0, 20.0, 30.0};
    const ScatterScene scene = scene_of(x, y);
    for (std::size_t k = 0; k < x.size(); ++k) {
        const ScatterAction action = clicked(scene, place(scene, k));
        CHECK(action.clicked == k);
        CHECK(action.hovered == k);
    }
    CHECK_FALSE(clicked(scene, {200.0F, 260.0F}).clicked);
}

TEST_CASE("scatter: larger values are farther right and higher; unrated pairs are not there") {
    const double none = std::nan("");
    const std::vector<double> x{1.0, 2.0, 3.0};
    const std::vector<double> y{1.0, none, 2.0};
    const ScatterScene scene = scene_of(x, y);
    const ImVec2 low = place(scene, 0);
    const ImVec2 high = place(scene, 2);
    CHECK(low.x < high.x);
    CHECK(low.y > high.y);
    CHECK(kArea.contains(low));
    CHECK(kArea.contains(high));
    CHECK_FALSE(clicked(scene, (low + high) * 0.5F).clicked);
}

TEST_CASE("scatter: no points, one point, equal points and thousands all can be drawn") {
    for (const std::size_t count : {0UL, 1UL, 2UL, 20'000UL}) {
        const std::vector<double> same(count, 7.0);
        ScatterScene scene = scene_of(same, same);
        scene.fitted = same;
        const ScatterAction action = clicked(scene, count == 0 ? kArea.centre() : place(scene, 0));
        CHECK(action.clicked.has_value() == (count > 0));
    }
}

TEST_CASE("scatter: values that differ by rounding alone can be drawn") {
    const std::vector<double> x{1.0, 1.0 + 2.3e-16, 1.0 - 1.2e-16};
    const std::vector<double> y{1e-300, 0.0, 1e-18};
    const ScatterScene scene = scene_of(x, y);
    CHECK(clicked(scene, place(scene, 1)).clicked.has_value());
}

TEST_CASE("scatter: points and the monotone fit are seen in both themes") {
    const std::vector<double> x{1.0, 2.0, 3.0, 4.0, 5.0};
    const std::vector<double> y{1.0, 3.0, 2.0, 4.0, 5.0};
    const std::vector<double> fitted{1.0, 2.5, 2.5, 4.0, 5.0};
    for (const bool dark : {true, false}) {
        PictureOptions options;
        options.dark = dark;
        Theme used;
        const Image image = draw_picture(400, 300, options, [&](const Theme& theme) {
            used = theme;
            ScatterScene scene = scene_of(x, y);
            scene.fitted = fitted;
            draw_scatter("s", theme, kArea, scene);
        });
        CHECK(count_pixels(image, kArea, used.text) > 100);
        CHECK(count_pixels(image, kArea, mixed(used.pane, used.series, 0.8F)) > 20);
    }
}

TEST_CASE("scatter: the fit has no spurs where pairs are tied or steps are narrower than a pixel") {
    std::vector<double> x;
    std::vector<double> fitted;
    for (std::size_t k = 0; k < 90; ++k) {
        x.push_back(k < 60 ? static_cast<double>(k / 3) : 20.0 + 0.01 * static_cast<double>(k));
        fitted.push_back(static_cast<double>(k / 2));
    }
    const std::vector<double> none(x.size(), std::nan(""));
    std::vector<ImVec2> line;
    Theme used;
    const Image image = draw_picture(400, 300, {}, [&](const Theme& theme) {
        used = theme;
        ScatterScene scene = scene_of(x, none);
        scene.fitted = fitted;
        line = scatter_fit_line(theme, kArea, scene);
        draw_scatter("s", theme, kArea, scene);
    });
    REQUIRE(line.size() > 50);
    const auto is_on_line = [&line](ImVec2 at) {
        constexpr float kBesidePx = 2.0F;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const Rect step{{std::min(line[k].x, line[k + 1].x) - kBesidePx,
                             std::min(line[k].y, line[k + 1].y) - kBesidePx},
                            {std::max(line[k].x, line[k + 1].x) + kBesidePx,
                             std::max(line[k].y, line[k + 1].y) + kBesidePx}};
            if (step.contains(at)) return true;
        }
        return false;
    };
    int beside = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const ImVec2 at{static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F};
            if (pixel(image, column, row) == used.text && !is_on_line(at)) ++beside;
        }
    }
    CHECK(beside == 0);
}

// 2, 260 and 1,000 patterns; from 260 on, one polyline of all pairs overflowed its indices.
TEST_CASE("scatter: the fit is drawn where it is, from end to end, of any number of pairs" *
          doctest::test_suite("long")) {
    for (const std::size_t count : {1UL, 2UL, 5UL, 66UL, 33'670UL, 499'500UL}) {
        for (const std::size_t level : {1UL, 3UL, 1000UL}) {
            const DrawnFit fit = fit_of(Pairs(count, level));
            REQUIRE_FALSE(fit.line.empty());
            CHECK(same(fit.line.front(), fit.whole.front()));
            CHECK(same(fit.line.back(), fit.whole.back()));
            CHECK(fit.line.size() <= 4 * 400);
            CHECK(farthest_px(fit) <= 1e-3F);
            for (std::size_t k = 1; k < fit.line.size(); ++k) {
                CHECK(fit.line[k].x >= fit.line[k - 1].x);
                CHECK(fit.line[k].y <= fit.line[k - 1].y);
                // Steps: horizontal or vertical.
                const bool is_step =
                    fit.line[k].x == fit.line[k - 1].x || fit.line[k].y == fit.line[k - 1].y;
                CHECK(is_step);
            }
        }
    }
}

TEST_CASE("scatter: where pairs are farther apart than pixels, every one is a corner of the fit") {
    const DrawnFit fit = fit_of(Pairs(66, 3));
    for (const ImVec2& pair : fit.whole) {
        CHECK(std::ranges::any_of(fit.line, [&](ImVec2 corner) { return same(corner, pair); }));
    }
}

TEST_CASE("scatter: no drawing outgrows ImGui's indices, in the widest picture either") {
    const Pairs pairs(499'500, 1);
    for (const ImVec2 size : {ImVec2{800, 600}, ImVec2{16'000, 900}}) {
        const Cost cost = cost_of(pairs.scene(), size);
        CHECK(cost.vertices > 1000);
        CHECK(cost.vertices < 40.0F * size.x + 100'000.0F);
        CHECK(cost.most_in_a_command < 65'536);
    }
}

TEST_CASE("scatter: what a caller has kept of its pairs draws the same") {
    const Pairs pairs(5000, 3);
    const ScatterSummary summary = summary_of(pairs.x, pairs.y, pairs.fitted);
    ScatterScene kept = pairs.scene();
    kept.summary = &summary;
    const auto picture = [](const ScatterScene& scene) {
        return draw_picture(400, 300, {},
                            [&](const Theme& theme) { draw_scatter("s", theme, kArea, scene); });
    };
    CHECK(picture(kept) == picture(pairs.scene()));
    CHECK(summary_of({}, {}, {}).fit.empty());
}

}  // namespace scatter_view_test
