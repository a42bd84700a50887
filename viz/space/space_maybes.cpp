#include <algorithm>
#include <cmath>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_parts.h"

namespace tact {

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
