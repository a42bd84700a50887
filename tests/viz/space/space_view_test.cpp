#include "viz/space/space_view.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "model/common/random.h"
#include "tests/support/presence.h"
#include "viz/drawing/colour.h"
#include "viz/space/space_parts.h"

namespace tact::space_view_test {
namespace {

const Rect kPane{{0, 0}, {600, 400}};

struct Example {
    std::vector<std::string> labels;
    std::vector<PatternLook> looks;
    Eigen::MatrixXd points;
};

Example example(int n, int dimensions) {
    std::mt19937 random(7);
    std::normal_distribution<double> value;
    Example result;
    result.points.resize(n, dimensions);
    for (int i = 0; i < n; ++i) {
        result.labels.push_back("pattern " + std::to_string(i));
        result.looks.push_back(pattern_look(dark_theme(1.0F), static_cast<std::size_t>(i)));
        for (int k = 0; k < dimensions; ++k) result.points(i, k) = value(random);
    }
    return result;
}

SpaceScene scene_of(const Example& e) {
    return {.labels = e.labels, .looks = e.looks, .points = &e.points};
}

Image picture(const SpaceScene& scene, std::optional<ImVec2> mouse = std::nullopt,
              SpaceAction* action = nullptr) {
    return draw_picture(600, 400, {.mouse_px = mouse}, [&](const Theme& theme) {
        SpaceCamera camera;
        const SpaceAction result = draw_space("space", theme, kPane, scene, camera);
        if (action != nullptr) *action = result;
    });
}

// A window with one space, driven by hand: every call of frame() is one frame.
struct Bench {
    ImGuiContext* before = ImGui::GetCurrentContext();
    ImGuiContext* own = ImGui::CreateContext();
    Theme theme = dark_theme(1.0F);
    SpaceCamera camera;

    Bench() {
        ImGui::SetCurrentContext(own);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {600, 400};
        theme.fonts = load_fonts(*io.Fonts, 1.0F, "");
    }
    ~Bench() {
        ImGui::DestroyContext(own);
        ImGui::SetCurrentContext(before);
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    SpaceAction frame(const SpaceScene& scene, ImVec2 mouse, int button_down = -1,
                      float wheel = 0.0F) {
        ImGuiIO& io = ImGui::GetIO();
        io.DeltaTime = 1.0F / 60.0F;
        io.MousePos = mouse;
        io.MouseWheel = wheel;
        for (int b = 0; b < 3; ++b) io.MouseDown[b] = b == button_down;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({600, 400});
        ImGui::Begin("bench", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        const SpaceAction action = draw_space("space", theme, kPane, scene, camera);
        ImGui::End();
        ImGui::Render();
        return action;
    }

    ImVec2 place_of(const Example& e, Eigen::Index i) const {
        return project(camera, fit(e.points), kPane, point_of(e.points, i)).at;
    }
};

// The point nearest to the eye: nothing hides it.
Eigen::Index front(const Example& e) {
    Eigen::Index best = 0;
    double depth = -10;
    for (Eigen::Index i = 0; i < e.points.rows(); ++i) {
        const double d = project({}, fit(e.points), kPane, point_of(e.points, i)).depth;
        if (d > depth) {
            depth = d;
            best = i;
        }
    }
    return best;
}

const ImVec2 kEmpty{30, 30};

}  // namespace

TEST_CASE("space view: 1, 12 and 1000 patterns all show, in 2-D and 3-D") {
    for (const int dimensions : {2, 3}) {
        for (const int n : {1, 12, 1000}) {
            const Example e = example(n, dimensions);
            const Image image = picture(scene_of(e));
            const ImU32 pane = dark_theme(1.0F).pane;
            CHECK(600 * 400 - count_pixels(image, kPane, pane, 12) > 60 * std::min(n, 100));
        }
    }
}

TEST_CASE("space view: a click on a point selects it, a double click plays it") {
    const Example e = example(12, 3);
    Bench bench;
    const auto i = static_cast<std::size_t>(front(e));
    const ImVec2 at = bench.place_of(e, front(e));
    bench.frame(scene_of(e), at);
    CHECK(bench.frame(scene_of(e), at).hovered == i);
    CHECK_FALSE(bench.frame(scene_of(e), at, 0).clicked.has_value());
    CHECK(bench.frame(scene_of(e), at).clicked == i);
    CHECK(bench.frame(scene_of(e), at, 0).double_clicked == i);
}

TEST_CASE("space view: a drag on empty space orbits, even over points, and is no click") {
    const Example e = example(12, 3);
    Bench bench;
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty, 0);
    const SpaceCamera before = bench.camera;
    for (int step = 1; step <= 20; ++step) {
        const float way = 15.0F * static_cast<float>(step);
        const SpaceAction action = bench.frame(scene_of(e), kEmpty + ImVec2{way, way / 2}, 0);
        CHECK_FALSE(action.hovered.has_value());
        CHECK(action.camera_changed);
    }
    const SpaceAction released = bench.frame(scene_of(e), kEmpty + ImVec2{300, 150});
    CHECK_FALSE(released.clicked_empty);
    CHECK_FALSE(released.clicked.has_value());
    CHECK(bench.camera.yaw_rad > before.yaw_rad + 1.0);
    CHECK(bench.camera.pitch_rad > before.pitch_rad);
    CHECK(bench.camera.zoom == before.zoom);
}

TEST_CASE("space view: a drag that begins on a point leaves the camera alone") {
    const Example e = example(12, 3);
    Bench bench;
    const ImVec2 at = bench.place_of(e, front(e));
    bench.frame(scene_of(e), at);
    bench.frame(scene_of(e), at);
    bench.frame(scene_of(e), at, 0);
    bench.frame(scene_of(e), at + ImVec2{50, 0}, 0);
    CHECK_FALSE(bench.frame(scene_of(e), at + ImVec2{50, 0}).clicked.has_value());
    CHECK(bench.camera == SpaceCamera{});
}

TEST_CASE("space view: a flat map is moved, not turned, by a drag") {
    const Example e = example(12, 2);
    Bench bench;
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty, 0);
    const ImVec2 before = bench.place_of(e, 0);
    bench.frame(scene_of(e), kEmpty + ImVec2{40, 25}, 0);
    const ImVec2 after = bench.place_of(e, 0);
    // Float pixels.
    CHECK(std::abs(after.x - before.x - 40.0F) <= 1e-2F);
    CHECK(std::abs(after.y - before.y - 25.0F) <= 1e-2F);
}

TEST_CASE("space view: right drag pans, the wheel zooms at the mouse, a double click resets") {
    const Example e = example(12, 3);
    Bench bench;
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty);
    bench.frame(scene_of(e), kEmpty, 1);
    bench.frame(scene_of(e), kEmpty + ImVec2{30, 0}, 1);
    bench.frame(scene_of(e), kEmpty);
    CHECK(bench.camera.pan_x > 0.1);
    bench.frame(scene_of(e), kEmpty, -1, 2.0F);
    CHECK(std::abs(bench.camera.zoom - 1.15 * 1.15) <= 1e-9);
    bench.frame(scene_of(e), kEmpty);
    CHECK(bench.frame(scene_of(e), kEmpty, 0).hovered == std::nullopt);
    CHECK(bench.frame(scene_of(e), kEmpty).clicked_empty);
    bench.frame(scene_of(e), kEmpty, 0);
    bench.frame(scene_of(e), kEmpty);
    CHECK(bench.camera == SpaceCamera{});
}

TEST_CASE("space view: the selected point and the hovered one are joined, with their distance") {
    const Example e = example(12, 3);
    SpaceScene scene = scene_of(e);
    scene.selected = 3;
    scene.pointed = 8;
    std::size_t asked = 0;
    scene.dissimilarity = [&](std::size_t a, std::size_t b) {
        ++asked;
        CHECK(a == 3);
        CHECK(b == 8);
        return 10.2;
    };
    const Image image = picture(scene);
    CHECK(asked == 2);  // once a frame
    CHECK(count_pixels(image, kPane, dark_theme(1.0F).hover) > 200);
}

TEST_CASE("space view: what is selected or chosen lies over what is not, whatever its depth") {
    Example e = example(2, 3);
    e.labels = {"", ""};
    for (const Eigen::Index far : {0, 1}) {
        // One behind the other, seen by the camera as it is at first.
        const Eigen::Vector3d to_eye = turn_of({}, false).row(2);
        e.points.row(far) = -to_eye;
        e.points.row(1 - far) = to_eye;
        const std::vector<std::size_t> behind{static_cast<std::size_t>(far)};
        SpaceScene plain = scene_of(e);
        SpaceScene selected = scene_of(e);
        selected.selected = behind[0];
        SpaceScene chosen = scene_of(e);
        chosen.chosen = behind;
        const auto colour_at = [&e, far](const SpaceScene& scene) {
            const ImVec2 at = project({}, fit(e.points), kPane, point_of(e.points, far)).at;
            return pixel(picture(scene), static_cast<int>(at.x), static_cast<int>(at.y));
        };
        const ImU32 own = e.looks[behind[0]].colour;
        CHECK(colour_at(selected) == own);
        CHECK(colour_at(chosen) != colour_at(plain));
    }
}

TEST_CASE("space view: points without coordinates are left out, not drawn at random") {
    Example e = example(12, 3);
    e.points.row(4).setConstant(NAN);
    SpaceScene scene = scene_of(e);
    scene.selected = 4;
    const std::vector<std::vector<std::size_t>> paths{{3, 4, 5}};
    scene.paths = paths;
    picture(scene);
    e.points.setConstant(NAN);
    picture(scene);
}

TEST_CASE("space view: an empty set draws a floor and does not fail") {
    const Example e = example(0, 3);
    picture(scene_of(e));
}

TEST_CASE("space view: beside a subset of many points the others are a cloud without names") {
    for (const int n : {12, 90}) {
        const Example e = example(n, 3);
        Example nameless = e;
        for (std::size_t k = 2; k < nameless.labels.size(); ++k) nameless.labels[k].clear();
        const std::vector<std::size_t> chosen{0, 1};
        SpaceScene named = scene_of(e);
        SpaceScene bare = scene_of(nameless);
        named.chosen = bare.chosen = chosen;
        CHECK((picture(named) == picture(bare)) == (n == 90));
        named.chosen = bare.chosen = {};
        CHECK(picture(named) != picture(bare));
    }
}

TEST_CASE("space: ten thousand points with all their lines and ellipses are bounded work") {
    const Example e = example(10'000, 3);
    const std::vector<Eigen::Matrix3Xd> spread(10'000, 0.1 * Eigen::Matrix3Xd::Identity(3, 5));
    std::vector<SpaceLink> links;
    for (std::size_t k = 0; k < 1'000'000; ++k) links.push_back({k % 10'000, k * 31 % 10'000});
    SpaceScene scene = scene_of(e);
    scene.links = links;
    scene.spread = spread;
    int vertices = 0;
    int links_alone = 0;
    for (int* count : {&vertices, &links_alone}) {
        draw_picture(600, 400, {}, [&](const Theme& theme) {
            SpaceCamera camera;
            draw_space("space", theme, kPane, scene, camera);
            *count = ImGui::GetWindowDrawList()->VtxBuffer.Size;
        });
        scene.spread = {};
    }
    // Rim, mark and ring of each point; a line's and an ellipse's few dozen; names.
    CHECK(vertices < 12 * 10'000 + 8 * 4'000 + 200 * 500 + 50'000);
    CHECK(links_alone > 8 * 10'000 + 4 * 4'000);
    CHECK(links_alone < vertices);
}

TEST_CASE("space: an ellipse holds half of the draws, however they lie about the point") {
    RandomStream random{5};
    for (int cloud = 0; cloud < 60; ++cloud) {
        // Normal ones, off their point by up to two deviations, bent, or nearly on a line.
        const double off = 0.5 * (cloud % 5);
        const double bend = cloud % 3 == 0 ? 2.0 : 0.0;
        const double thin = cloud % 4 == 0 ? 1e-3 : 1.0;
        Eigen::Matrix2Xd moves(2, 100);
        for (Eigen::Index k = 0; k < 100; ++k) {
            const double x = next_normal(random) + off;
            moves.col(k) << 30.0 * x, 30.0 * thin * (next_normal(random) + bend * x * x);
        }
        const auto half = half_ellipse(moves);
        REQUIRE(half);
        const Eigen::Matrix2Xd white = half->inverse() * moves;
        const auto inside = (white.colwise().norm().array() <= 1.0 + 1e-9).count();
        CHECK(inside == 50);
    }
    CHECK_FALSE(half_ellipse(Eigen::Matrix2Xd(2, 0)));
    CHECK(half_ellipse(Eigen::Matrix2Xd::Zero(2, 4))->norm() <= 1e-3);
}

TEST_CASE("space: a point of any colour of the map stands out from the pane") {
    for (const bool dark : {true, false}) {
        for (const double value : {0.0, 0.2, 0.5, 1.0}) {
            Example e = example(1, 2);  // flat: in space what is far steps back
            e.looks[0] = {viridis(value), false};
            e.labels[0] = "";
            Theme used;
            const Image image = draw_picture(600, 400, {.dark = dark}, [&](const Theme& theme) {
                used = theme;
                SpaceCamera camera;
                draw_space("space", theme, kPane, scene_of(e), camera);
            });
            const ImVec2 middle = kPane.centre();
            double most = 0.0;
            for (int x = -20; x <= 20; ++x) {
                for (int y = -20; y <= 20; ++y) {
                    const ImU32 seen = pixel(image, static_cast<int>(middle.x) + x,
                                             static_cast<int>(middle.y) + y);
                    most = std::max(most, contrast(seen, used.pane));
                }
            }
            CHECK_MESSAGE(most >= 3.0, "viridis ", value);
        }
    }
}

}  // namespace tact::space_view_test
