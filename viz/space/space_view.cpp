#include "viz/space/space_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_gestures.h"
#include "viz/space/space_parts.h"

namespace tact {

namespace {

// What the mouse can do where it is. Returns what that covers.
Rect draw_hint(const SpaceStage& stage, const SpaceAction& action) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return {};
    const Theme& theme = stage.theme;
    const std::string_view text = stage.scene.takes_place ? "click where it belongs, wheel to zoom"
                                  : action.hovered        ? stage.scene.point_hint
                                  : stage.fit.flat
                                      ? "drag to move, Shift+drag to select, wheel to zoom"
                                      : "drag to turn, Shift+drag to select, wheel to zoom";
    if (text.empty()) return {};
    const ImVec2 size = text_size(theme.fonts.small, text);
    const float left = stage.pane.max.x - size.x - theme.gap_px;
    if (left < stage.pane.min.x + stage.pane.width() * 0.3F) return {};
    const Rect place = rect_at({left, stage.pane.max.y - size.y - theme.gap_px}, size);
    draw_text(stage.list, theme.fonts.small, place.min, toned(stage, theme.dim_text, 0.8F), text);
    return place;
}

}  // namespace

SpaceAction draw_space(const char* id, const Theme& theme, const Rect& pane,
                       const SpaceScene& scene, SpaceCamera& camera) {
    assert(scene.points != nullptr && "a space has points");
    assert(scene.labels.size() == static_cast<std::size_t>(scene.points->rows()) &&
           scene.looks.size() == scene.labels.size() && "one name and one look for each point");
    if (pane.width() < 1.0F || pane.height() < 1.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    SpaceStage stage = staged(list, theme, pane, scene);
    place_points(stage, camera);
    const SpaceAction action = read_mouse(id, theme, pane, stage, camera);
    if (action.camera_changed) place_points(stage, camera);
    const std::optional<std::size_t> hovered = action.hovered ? action.hovered : scene.pointed;

    list.PushClipRect(pane.min, pane.max, true);
    draw_floor(stage, camera);
    draw_shadows(stage);
    draw_drop_lines(stage, hovered);
    draw_paths(stage);
    draw_cloud(stage);
    draw_spread(stage);
    draw_links(stage);
    draw_ghosts(stage);
    const Rect cross = draw_axes_cross(stage, camera);
    std::array<Rect, 4> occupied{cross, draw_hint(stage, action), draw_scale_bar(stage, cross),
                                 Rect{}};
    const bool pair = hovered && scene.selected && *hovered != *scene.selected &&
                      std::max(*hovered, *scene.selected) < scene.labels.size() &&
                      somewhere(stage, *hovered) && somewhere(stage, *scene.selected);
    if (pair) draw_pair_line(stage, *scene.selected, *hovered);
    draw_track(stage, action.on_track);
    draw_points(stage, hovered);
    draw_proposals(stage, action.proposal);
    draw_wanted(stage);
    if (pair) occupied[3] = draw_pair_value(stage, *scene.selected, *hovered);
    draw_names(stage, occupied, hovered);
    draw_gesture(stage, camera, hovered);
    if (scene.stale) draw_stale(list, theme, pane, ImGui::GetTime());
    list.PopClipRect();
    return action;
}

namespace {

void draw_dashes(const SpaceStage& stage, ImVec2 from, ImVec2 to, ImU32 ink) {
    const ImVec2 way = to - from;
    const float length = std::hypot(way.x, way.y);
    const float dash = 4.0F * stage.theme.scale;
    for (float s = 0.0F; s < length; s += 2.0F * dash) {
        stage.list.AddLine(from + way * (s / length),
                           from + way * (std::min(s + dash, length) / length), ink,
                           stage.theme.hairline_px);
    }
}

void write_beside(const SpaceStage& stage, const Disc& disc, const std::string& words) {
    const Theme& theme = stage.theme;
    const ImVec2 size = text_size(theme.fonts.regular, words);
    const float pad = 3.0F * theme.scale;
    const ImVec2 corner = disc.centre + ImVec2{disc.radius + 2.0F * pad, -size.y / 2.0F};
    const Rect plate = moved_into(inset(rect_at(corner, size), -pad), stage.pane);
    stage.list.AddRectFilled(plate.min, plate.max, theme.hover, theme.rounding_px);
    draw_text(stage.list, theme.fonts.regular, inset(plate, pad).min, theme.text, words);
}

}  // namespace

void draw_cloud(const SpaceStage& stage) {
    for (const ImVec2 at : stage.cloud) {
        draw_disc(stage.list, stage.theme, at, 2.0F * stage.theme.scale,
                  faded(stage.theme.accent, 0.5F));
    }
}

void draw_track(const SpaceStage& stage, std::optional<std::size_t> on_track) {
    const Theme& theme = stage.theme;
    if (stage.track.size() < 2) return;
    stage.list.AddPolyline(stage.track.data(), static_cast<int>(stage.track.size()),
                           faded(theme.accent, 0.55F), 0, 1.5F * theme.scale);
    for (const ImVec2 end : {stage.track.front(), stage.track.back()}) {
        draw_disc(stage.list, theme, end, 2.5F * theme.scale, faded(theme.accent, 0.8F));
    }
    const auto& words = stage.scene.maybes.track_words;
    const auto write = [&](std::size_t k) {
        if (k < words.size()) write_beside(stage, {stage.track[k], 4.0F * theme.scale}, words[k]);
    };
    if (on_track && *on_track < stage.track.size()) {
        draw_disc(stage.list, theme, stage.track[*on_track], 4.0F * theme.scale, theme.accent);
        return write(*on_track);
    }
    write(0);
    write(stage.track.size() - 1);
}

void draw_proposals(const SpaceStage& stage, std::optional<std::size_t> pointed) {
    const Theme& theme = stage.theme;
    const auto& names = stage.scene.maybes.proposal_names;
    for (std::size_t k = 0; k < stage.proposals.size(); ++k) {
        const Disc& disc = stage.proposals[k];
        const bool lit = pointed == k || stage.scene.maybes.lit == k;
        if (stage.scene.selected && somewhere(stage, *stage.scene.selected)) {
            draw_dashes(stage, stage.discs[*stage.scene.selected].centre, disc.centre,
                        faded(theme.accent, lit ? 0.9F : 0.35F));
        }
        stage.list.AddCircleFilled(disc.centre, disc.radius, faded(theme.pane, 0.7F));
        stage.list.AddCircle(disc.centre, disc.radius, faded(theme.accent, lit ? 1.0F : 0.7F), 0,
                             (lit ? 2.5F : 1.5F) * theme.scale);
    }
    const auto named = pointed ? pointed : stage.scene.maybes.lit;
    if (named && *named < stage.proposals.size() && *named < names.size()) {
        write_beside(stage, stage.proposals[*named], names[*named]);
    }
}

void draw_wanted(const SpaceStage& stage) {
    const auto& maybes = stage.scene.maybes;
    if (!maybes.wanted) return;
    const auto seen = [&](const Eigen::RowVectorXd& at) {
        const Eigen::MatrixXd row = at;
        return stage.seen(point_of(row, 0)).at;
    };
    const ImVec2 wanted = seen(*maybes.wanted);
    const float arm = 8.0F * stage.theme.scale;
    const float width = 2.0F * stage.theme.scale;
    stage.list.AddLine(wanted - ImVec2{arm, 0}, wanted + ImVec2{arm, 0}, stage.theme.accent, width);
    stage.list.AddLine(wanted - ImVec2{0, arm}, wanted + ImVec2{0, arm}, stage.theme.accent, width);
    if (!maybes.reached) return;
    const ImVec2 reached = seen(*maybes.reached);
    draw_dashes(stage, wanted, reached, stage.theme.warning);
    stage.list.AddCircle(reached, arm, stage.theme.warning, 0, width);
}

}  // namespace tact
