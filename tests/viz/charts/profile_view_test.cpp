// Profiles of an objective: places of their points, and values read off them.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/support/headless_window.h"
#include "viz/charts/profile_view.h"

namespace profile_view_test {

using namespace tact;

namespace {

const std::vector<double> kBest{0.2, 0.5, 0.9, 0.7, -std::numeric_limits<double>::infinity()};

struct ProfileWindow {
    HeadlessWindow window;
    Theme theme = dark_theme(1.0F);
    Rect area{{40.0F, 30.0F}, {240.0F, 130.0F}};
    ProfileScene scene;
    std::optional<std::size_t> hovered;

    ProfileWindow() {
        scene.title = "w_NC  0.5";
        scene.best = kBest;
        scene.shown = {0.2, 0.9};
        scene.chosen = 2;
        scene.before = 0;
    }

    void settle() {
        window.settle([this] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({800, 600});
            ImGui::Begin("test");
            hovered = draw_profile("w_NC", theme, area, scene);
            ImGui::End();
        });
    }
    // Fonts exist only within frames.
    ImVec2 point(std::size_t k) {
        ImVec2 at;
        window.frame([&] { at = profile_point(theme, area, scene, k); });
        return at;
    }
};

}  // namespace

TEST_CASE("profile: better values stand higher, values go from left to right, all inside") {
    ProfileWindow profile;
    CHECK(profile.point(2).y < profile.point(3).y);
    CHECK(profile.point(3).y < profile.point(1).y);
    CHECK(profile.point(1).y < profile.point(0).y);
    for (std::size_t k = 0; k < kBest.size(); ++k) {
        CHECK(profile.area.contains(profile.point(k)));
        if (k > 0) CHECK(profile.point(k - 1).x < profile.point(k).x);
    }
    CHECK(profile.point(4).y == profile.point(0).y);  // without an order: at the bottom
}

TEST_CASE("profile: one range for several, so that a flat one is drawn flat") {
    ProfileWindow profile;
    const std::vector<double> flat{0.9, 0.895, 0.89};
    const float steep_px = profile.point(0).y - profile.point(2).y;
    profile.scene.best = flat;
    const float flat_px = profile.point(2).y - profile.point(0).y;
    CHECK(flat_px > 0.0F);
    CHECK(flat_px < 0.02F * steep_px);
}

TEST_CASE("profile: the mouse reads the value it is nearest to, and none outside") {
    ProfileWindow profile;
    for (const std::size_t k : {0U, 3U}) {
        profile.window.move(profile.point(k));
        profile.settle();
        CHECK(profile.hovered == k);
    }
    profile.window.move({600.0F, 400.0F});
    profile.settle();
    CHECK_FALSE(profile.hovered);
}

TEST_CASE("profile: nothing to show, or no room for it, is drawn as nothing") {
    ProfileWindow profile;
    profile.scene.best = {};
    profile.window.move(profile.area.centre());
    profile.settle();
    CHECK_FALSE(profile.hovered);
    profile.scene.best = kBest;
    profile.area = {{40.0F, 30.0F}, {44.0F, 36.0F}};
    profile.window.move(profile.area.centre());
    profile.settle();
    CHECK_FALSE(profile.hovered);
}

}  // namespace profile_view_test
