#include "viz/space/space_stage.h"

#include <algorithm>
#include <cmath>

#include "viz/drawing/colour.h"

namespace tact {
namespace {

// Fewer points are larger: a dozen should look like objects, a thousand like a cloud. In a small
// pane they are smaller: a near one at its rim stays whole.
float base_radius_px(const Theme& theme, std::size_t n, const Rect& pane) {
    constexpr float kOfPane = 0.032F;
    constexpr float kLeastPx = 4.0F;
    const float crowd =
        std::clamp(std::log10(static_cast<float>(std::max<std::size_t>(n, 1)) / 20.0F), 0.0F, 2.0F);
    const float most =
        std::max(kLeastPx * theme.scale, kOfPane * std::min(pane.width(), pane.height()));
    return std::min(theme.scale * (9.0F - 3.0F * crowd), most);
}

// Arrows are seen from end to end. Ghosts without them come and go: the map stands still meanwhile.
SpaceFit fit_of(const SpaceScene& scene) {
    const Eigen::MatrixXd& now = *scene.points;
    const Eigen::MatrixXd* before = scene.arrows ? scene.ghosts : nullptr;
    if (before == nullptr || before->cols() != now.cols()) return fit(now);
    Eigen::MatrixXd both(now.rows() + before->rows(), now.cols());
    both << now, *before;
    return fit(both);
}

}  // namespace

SpaceStage staged(ImDrawList& list, const Theme& theme, const Rect& pane, const SpaceScene& scene) {
    return {list, theme, pane, scene, fit_of(scene), {}, {}, {}, {}, {}, {}, {}, {}, {}};
}

float nearness(const SpaceStage& stage, std::size_t i) {
    return static_cast<float>(std::clamp((stage.projected[i].depth + 1.0) / 2.0, 0.0, 1.0));
}

float presence(const SpaceStage& stage, std::size_t i) {
    // On white a faded colour is soon no colour.
    const float farthest = stage.theme.is_dark ? 0.55F : 0.75F;
    const float depth = stage.fit.flat ? 1.0F : farthest + (1.0F - farthest) * nearness(stage, i);
    if (stage.faint[i]) return 0.2F * depth;
    return stage.scene.chosen.empty() || stage.chosen[i] ? depth : 0.55F * depth;
}

ImU32 toned(const SpaceStage& stage, ImU32 colour, float strength) {
    return mixed(stage.theme.pane, colour, strength);
}

bool somewhere(const SpaceStage& stage, std::size_t i) { return stage.discs[i].radius > 0.0F; }

bool visible(const SpaceStage& stage, const Disc& disc) {
    const Rect near = inset(stage.pane, -disc.radius);
    return std::isfinite(disc.centre.x) && std::isfinite(disc.centre.y) &&
           near.contains(disc.centre);
}

bool asked_for(const SpaceStage& stage, std::optional<std::size_t> hovered, std::size_t i) {
    return hovered == i || stage.scene.selected == i;
}

bool is_selected(const SpaceStage& stage, std::size_t i) {
    return stage.scene.selected == i || stage.selected_too[i];
}

bool is_cloud(const SpaceStage& stage, std::size_t i) {
    constexpr std::size_t kMany = 40;
    return stage.discs.size() > kMany && !stage.scene.chosen.empty() && !stage.chosen[i];
}

int layer(const SpaceStage& stage, std::optional<std::size_t> hovered, std::size_t i) {
    if (stage.scene.selected == i) return 0;
    if (stage.selected_too[i]) return 1;
    if (stage.chosen[i] && !stage.faint[i]) return 2;
    if (hovered == i) return 3;
    if (is_cloud(stage, i)) return 6;
    return stage.faint[i] ? 5 : 4;
}

void place_maybes(SpaceStage& stage) {
    const auto places = [&](const Eigen::MatrixXd* points) {
        std::vector<ImVec2> seen;
        for (Eigen::Index i = 0; points != nullptr && i < points->rows(); ++i) {
            seen.push_back(stage.seen(point_of(*points, i)).at);
        }
        return seen;
    };
    const float radius = 0.9F * base_radius_px(stage.theme, stage.scene.labels.size(), stage.pane);
    stage.proposals.clear();
    for (const ImVec2 at : places(stage.scene.maybes.proposals)) {
        stage.proposals.push_back({at, radius});
    }
    stage.track = places(stage.scene.maybes.track);
    stage.cloud = places(stage.scene.maybes.cloud);
}

void place_points(SpaceStage& stage, const SpaceCamera& camera) {
    stage.seen = projection(camera, stage.fit, stage.pane);
    place_maybes(stage);
    const std::size_t n = stage.scene.labels.size();
    const float base = base_radius_px(stage.theme, n, stage.pane);
    stage.projected.resize(n);
    stage.discs.resize(n);
    stage.front_to_back.clear();
    stage.chosen.assign(n, false);
    for (const std::size_t i : stage.scene.chosen) stage.chosen[i] = true;
    stage.faint.assign(n, false);
    for (const std::size_t i : stage.scene.faint) stage.faint[i] = true;
    stage.selected_too.assign(n, false);
    for (const std::size_t i : stage.scene.selected_too) stage.selected_too[i] = true;
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
        if (!p.allFinite()) {
            // Nowhere; out of the way of names and mouse.
            stage.discs[i] = {{-1e6F, -1e6F}, 0.0F};
            continue;
        }
        stage.projected[i] = stage.seen(p);
        const float near = stage.fit.flat ? 1.0F : 0.7F + 0.6F * nearness(stage, i);
        stage.discs[i] = {stage.projected[i].at, base * near};
        if (visible(stage, stage.discs[i])) stage.front_to_back.push_back(i);
    }
    std::stable_sort(stage.front_to_back.begin(), stage.front_to_back.end(),
                     [&](std::size_t a, std::size_t b) {
                         const int over = layer(stage, std::nullopt, a);
                         const int under = layer(stage, std::nullopt, b);
                         if (over != under) return over < under;
                         return stage.projected[a].depth > stage.projected[b].depth;
                     });
}

}  // namespace tact
