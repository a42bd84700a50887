#include "viz/charts/scatter_view.h"

#include <doctest/doctest.h>

#include <cmath>

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

// What one frame says with the mouse at a place, pressed and let go there.
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

// Where a point is, in a frame with fonts.
ImVec2 place(const ScatterScene& scene, std::size_t index) {
    HeadlessWindow window;
    const Theme theme = dark_theme(1.0F);
    ImVec2 at{0, 0};
    window.frame([&] { at = scatter_point(theme, kArea, scene, index); });
    return at;
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
        CHECK(count_pixels(image, kArea, used.warning) > 100);
        CHECK(count_pixels(image, kArea, mixed(used.pane, used.accent, 0.8F)) > 20);
    }
}

}  // namespace scatter_view_test
