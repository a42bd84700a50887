#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/label_placement.h"
#include "viz/space/space_parts.h"

namespace tact {

namespace {

// At the middle of the line, or above or below it or along it where that would cover a point.
Rect free_plate(const SpaceStage& stage, ImVec2 size, ImVec2 from, ImVec2 to) {
    const float lift = size.y + 8.0F * stage.theme.scale;
    Rect first;
    for (const float along : {0.5F, 0.4F, 0.6F, 0.3F, 0.7F}) {
        for (const float up : {0.0F, lift, -lift}) {
            const ImVec2 middle = from + (to - from) * along - ImVec2{0.0F, up};
            const Rect plate = moved_into(rect_at(middle - size * 0.5F, size), stage.pane);
            if (first.empty()) first = plate;
            const auto covered = [&](const Disc& d) {
                return squared_distance(plate, d.centre) < d.radius * d.radius;
            };
            if (std::none_of(stage.discs.begin(), stage.discs.end(), covered)) return plate;
        }
    }
    return first;
}

// The selected and the hovered name are in the larger font.
const ImFont* name_font(const SpaceStage& stage, std::optional<std::size_t> hovered,
                        std::size_t i) {
    const Fonts& fonts = stage.theme.fonts;
    return asked_for(stage, hovered, i) ? fonts.regular : fonts.small;
}

std::vector<LabelRequest> requests(const SpaceStage& stage, std::optional<std::size_t> hovered) {
    std::vector<std::size_t> order;
    for (const auto& first : {stage.scene.selected, hovered, stage.scene.pointed}) {
        if (first && *first < stage.discs.size() && visible(stage, stage.discs[*first]) &&
            std::find(order.begin(), order.end(), *first) == order.end()) {
            order.push_back(*first);
        }
    }
    const std::size_t asked = order.size();
    for (const std::size_t i : stage.front_to_back) {
        const auto end = order.begin() + static_cast<std::ptrdiff_t>(asked);
        if (order.size() >= kMostNames || !stage.selected_too[i]) continue;
        if (std::find(order.begin(), end, i) == end) order.push_back(i);
    }
    const std::size_t special = order.size();
    // Chosen ones before others, then from front to back.
    for (const bool chosen : {true, false}) {
        for (const std::size_t i : stage.front_to_back) {
            if (order.size() >= kMostNames) break;
            const auto end = order.begin() + static_cast<std::ptrdiff_t>(special);
            if (is_cloud(stage, i)) continue;
            if (stage.chosen[i] == chosen && std::find(order.begin(), end, i) == end) {
                order.push_back(i);
            }
        }
    }
    std::vector<LabelRequest> result;
    const float most_px = stage.pane.width() * 0.4F;
    const float least_px = 100.0F * stage.theme.scale;  // of a name that is still one
    for (const std::size_t i : order) {
        ImVec2 size = text_size(name_font(stage, hovered, i), stage.scene.labels[i]);
        size.x = std::min(size.x, most_px);
        result.push_back({i, size, least_px});
    }
    return result;
}

// Right or left of its point, or above or below it: in the pane, and never over the point.
Rect plate_beside(const SpaceStage& stage, const Disc& disc, ImVec2 size) {
    const float pad = 2.0F * stage.theme.scale;
    const float away = disc.radius + pad + stage.theme.scale;
    const ImVec2 half = size * 0.5F;
    Rect first;
    for (const ImVec2 off : {ImVec2{away + half.x, 0.0F}, ImVec2{-away - half.x, 0.0F},
                             ImVec2{0.0F, -away - half.y}, ImVec2{0.0F, away + half.y}}) {
        const ImVec2 corner = disc.centre + off - half;
        const Rect plate = moved_into(inset(rect_at(corner, size), -pad), stage.pane);
        if (first.empty()) first = plate;
        if (squared_distance(plate, disc.centre) >= disc.radius * disc.radius) return plate;
    }
    return first;
}

}  // namespace

void draw_pair_line(const SpaceStage& stage, std::size_t a, std::size_t b) {
    const ImVec2 from = stage.discs[a].centre;
    const ImVec2 along = stage.discs[b].centre - from;
    const float length = std::hypot(along.x, along.y);
    const float dash = 5.0F * stage.theme.scale;
    for (float s = 0.0F; s < length; s += 2.0F * dash) {
        stage.list.AddLine(from + along * (s / length),
                           from + along * (std::min(s + dash, length) / length),
                           stage.theme.warning, 1.5F * stage.theme.scale);
    }
}

// The pair's dissimilarity on a plate, whose place is returned.
Rect draw_pair_value(const SpaceStage& stage, std::size_t a, std::size_t b) {
    if (!stage.scene.dissimilarity) return {};
    const Theme& theme = stage.theme;
    std::string text = grouped(stage.scene.dissimilarity(a, b));
    if (!stage.scene.quantity.empty()) text = std::string{stage.scene.quantity} + " " + text;
    const ImVec2 pad{6.0F * theme.scale, 3.0F * theme.scale};
    const ImVec2 size = text_size(theme.fonts.semibold, text) + pad * 2.0F;
    const Rect plate = free_plate(stage, size, stage.discs[a].centre, stage.discs[b].centre);
    stage.list.AddRectFilled(plate.min, plate.max, theme.hover, theme.rounding_px);
    draw_text(stage.list, theme.fonts.semibold, plate.min + pad, theme.text, text);
    return plate;
}

void draw_names(const SpaceStage& stage, std::span<const Rect> occupied,
                std::optional<std::size_t> hovered) {
    const Theme& theme = stage.theme;
    const auto wanted = requests(stage, hovered);
    // The rings around points count as points; names may lie over a cloud.
    std::vector<Disc> discs = stage.discs;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const bool passed_over =
            is_cloud(stage, i) && !asked_for(stage, hovered, i) && stage.scene.pointed != i;
        if (passed_over) discs[i] = {{-1e6F, -1e6F}, 0.0F};
        const bool ringed =
            stage.chosen[i] || is_selected(stage, i) || asked_for(stage, hovered, i);
        if (ringed) discs[i].radius += (is_selected(stage, i) ? 5.5F : 4.0F) * theme.scale;
    }
    // Lines to many far names would be a web.
    constexpr std::size_t kMostLed = 60;
    const float far_px = wanted.size() <= kMostLed ? 14.0F * theme.scale : 0.0F;
    const ImVec2 apart{10.0F * theme.scale, 2.0F * theme.scale};
    const LabelField field{discs, occupied, stage.pane, 3.0F * theme.scale, far_px, apart};
    const auto placed = place_labels(wanted, field);
    // No free place, but asked for: on a plate, which keeps others from under it.
    std::vector<Rect> plates(wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const std::size_t i = wanted[k].disc;
        if (placed[k] || !asked_for(stage, hovered, i)) continue;
        plates[k] = plate_beside(stage, discs[i], wanted[k].size);
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const std::size_t i = wanted[k].disc;
        const ImFont* font = name_font(stage, hovered, i);
        const bool special = asked_for(stage, hovered, i);
        const float width = placed[k] ? placed[k]->width() : wanted[k].size.x;
        const std::string name = shortened(font, stage.scene.labels[i], width + 0.5F);
        const auto under = [&](const Rect& plate) {
            return !plate.empty() && plate.intersects(*placed[k]);
        };
        if (placed[k] && (special || std::none_of(plates.begin(), plates.end(), under))) {
            const float least = stage.chosen[i] ? 0.6F : 0.35F;
            const bool bright = special || is_selected(stage, i);
            const float strength = bright ? 1.0F : least + 0.4F * presence(stage, i);
            if (const auto line = leader(discs[i], *placed[k], field.gap_px)) {
                stage.list.AddLine(line->from, line->to, toned(stage, theme.dim_text, 0.6F),
                                   theme.hairline_px);
            }
            draw_text_halo(stage.list, font, placed[k]->min, toned(stage, theme.text, strength),
                           theme.pane, theme.scale, name);
        }
        if (plates[k].empty()) continue;
        stage.list.AddRectFilled(plates[k].min, plates[k].max, theme.hover, theme.rounding_px);
        draw_text(stage.list, font, inset(plates[k], 2.0F * theme.scale).min, theme.text, name);
    }
}

}  // namespace tact
