// The relay networks of one type, small, or of all four.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/stages/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/skin/network_view.h"

namespace tact {

namespace {

// "spikes", "excite 1" ..., "inhibit 1" ...
std::vector<std::string> layer_names(const NeuralCodingParams& params) {
    std::vector<std::string> names{"spikes"};
    for (int k = 1; k <= params.excitatory_layers; ++k)
        names.push_back("excite " + std::to_string(k));
    for (int k = 1; k <= params.inhibitory_layers; ++k)
        names.push_back("inhibit " + std::to_string(k));
    return names;
}

// Layers of one channel, computed when first shown in this step: large grids take milliseconds.
const std::vector<RelayLayer>& layers_of(const Timeline& timeline, Physiology& physiology,
                                         const ShownStages& shown, Receptor type) {
    ShownLayers& known = shown.pinned ? physiology.view.pinned_layers : physiology.view.layers;
    const std::size_t step = step_at(timeline, shown);
    if (known.of != shown.live || known.step != step) known = {shown.live, step, {}};
    const std::size_t c = index_of(type);
    if (known.layers[c].empty() && !shown.live->neural.code.central_count[c].empty()) {
        known.layers[c] =
            relay_layers(shown.live->neural.channel[c], step, shown.live->request.model.coding);
    }
    return known.layers[c];
}

constexpr const char* kNoSpikes = "no spikes in this step";

// If no spikes arrive, `place` says so; otherwise it has a legend if `legend` is set.
struct NetworkWords {
    Rect place;
    bool legend = true;
};

void draw_one_network(Ui& ui, const Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, Receptor type, const Rect& area,
                      const NetworkWords& words) {
    const std::vector<std::string> names = layer_names(shown.live->request.model.coding);
    const std::vector<RelayLayer>& layers = layers_of(timeline, physiology, shown, type);
    NetworkScene scene;
    scene.layers = layers;
    scene.names = names;
    scene.cap = shown.live->request.model.coding.spike_cap;
    scene.legend = false;
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("network ") + traits(type).afferent);
    const NetworkAction action = draw_network(id.c_str(), ui.theme, area, scene);
    note_rect(ui.rects, id, area.min, area.max);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImFont* font = ui.theme.fonts.small;
    if (!is_silent(scene)) {
        if (words.legend) draw_network_legend(list, ui.theme, words.place, scene.cap);
    } else if (text_size(font, kNoSpikes).x <= words.place.width()) {
        draw_text(list, font, words.place.min, ui.theme.dim_text, kNoSpikes);
    }
    if (!action.hovered) return;
    const NetworkCell& cell = *action.hovered;
    const double value = layers[cell.layer].at(cell.column, cell.row);
    const std::array<std::string, 3> lines{
        names[cell.layer] + ", " + traits(type).name, significant(value) + " impulses in 5 ms",
        "column " + std::to_string(cell.column) + ", row " + std::to_string(cell.row)};
    draw_readout(*ImGui::GetForegroundDrawList(), ui.theme,
                 {{0.0F, 0.0F}, ImGui::GetIO().DisplaySize}, ImGui::GetIO().MousePos, lines);
    const std::string exact = std::string(traits(type).afferent) + " " +
                              std::to_string(step_at(timeline, shown)) + " " +
                              std::to_string(cell.layer) + " " + std::to_string(cell.column) + " " +
                              std::to_string(cell.row) + " " + shortest_digits(value);
    note_rect(ui.rects, "under the mouse:network", area.min, area.max, exact);
}

// Four chips to choose the type whose network the overview shows; returns the rest of their line.
Rect draw_network_choice(Ui& ui, Physiology& physiology, const Rect& area) {
    PhysiologyState& state = physiology.view;
    const float gap = 2.0F * ui.theme.scale;
    float names_px = 0.0F;
    for (const Receptor type : kReceptors) names_px += chip_width(ui, traits(type).name) + gap;
    const bool in_full = names_px <= area.width();
    const float room = (area.width() - 3.0F * gap) / 4.0F - chip_width(ui, "");
    ImGui::SetCursorScreenPos(area.min);
    for (const Receptor type : kReceptors) {
        const char* const name = traits(type).name;
        const Item item{.id = std::string("network:") + traits(type).afferent,
                        .label = in_full ? name : shortened(ui.theme.fonts.small, name, room),
                        .tip = in_full ? "" : name};
        if (chip(ui, item, state.network == type)) {
            state.network = type;
            state.network_chosen = true;
        }
        ImGui::SameLine(0.0F, gap);
    }
    const float words_px = font_or_current(ui.theme.fonts.small).FontSize;
    const float top = area.min.y + 4.0F * ui.theme.scale;
    const float left = std::min(area.min.x + names_px, area.max.x);
    return {{left + 2.0F * ui.theme.gap_px, top}, {area.max.x, top + words_px}};
}

float chip_height(const Ui& ui) {
    return font_or_current(ui.theme.fonts.small).FontSize + 8.0F * ui.theme.scale;
}

}  // namespace

void draw_network_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                        const ShownStages& shown, const Rect& area, const StageSize& size) {
    const Theme& theme = ui.theme;
    if (!size.large) {
        PhysiologyState& state = physiology.view;
        if (!state.network_chosen) state.network = strongest_channel(*shown.live);
        Rect map = area;
        NetworkWords words;
        if (!shown.pinned) words.place = draw_network_choice(ui, physiology, area);
        // The second of a pair leaves the same room for the choice, so that both have the same
        // columns.
        map.min.y += chip_height(ui) + 2.0F * theme.scale;
        return draw_one_network(ui, timeline, physiology, shown, state.network, map, words);
    }
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float gap = theme.gap_px;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Names have a separate column: above the maps they would take height.
    const float height = (area.height() - 3.0F * gap) / 4.0F;
    const float names_px = text_size(theme.fonts.small, kNoSpikes).x + 2.0F * gap;
    const float words_px = height >= 2.4F * text_px ? names_px : 0.0F;  // below the name
    for (const Receptor type : kReceptors) {
        const ImVec2 corner{area.min.x,
                            area.min.y + static_cast<float>(index_of(type)) * (height + gap)};
        const ImU32 colour = theme.receptor[index_of(type)];
        const float mark_px = 2.6F * theme.mark_px;
        const ImVec2 named = corner + ImVec2{0.0F, std::floor(0.5F * height - 1.1F * text_px)};
        draw_receptor_mark(list, theme, named + ImVec2{theme.mark_px, 0.55F * text_px},
                           0.85F * theme.mark_px, type, colour);
        draw_text(list, theme.fonts.small, named + ImVec2{mark_px, 0.0F}, colour,
                  traits(type).name);
        draw_one_network(
            ui, timeline, physiology, shown, type,
            {corner + ImVec2{names_px, 0.0F}, corner + ImVec2{area.width(), height}},
            {rect_at(named + ImVec2{0.0F, 1.25F * text_px}, {words_px, text_px}), false});
    }
}

void draw_network_key(const Ui& ui, const ShownStages& shown, const Rect& line) {
    draw_network_legend(*ImGui::GetWindowDrawList(), ui.theme, line,
                        shown.live->request.model.coding.spike_cap);
}

}  // namespace tact
