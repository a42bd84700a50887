#include "app/physiology/receptor_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/timeline/time_rows.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/skin/network_view.h"
#include "viz/skin/raster_view.h"
#include "viz/skin/receptor_legend.h"
#include "viz/skin/receptor_view.h"

namespace tact {

namespace {

constexpr double kTiltS = 0.18;
// A flash fades in this time of the pattern; in steps of the model it then lasts for three.
constexpr double kFlashS = 0.015;

std::string id_of(const ShownStages& shown, const std::string& name) {
    return shown.pinned ? name + " pinned" : name;
}

// The step of the model that the playhead is in.
std::size_t step_at(const Timeline& timeline, const ShownStages& shown) {
    const std::size_t steps = shown.live->neural.code.central_count[0].size();
    const double step = std::floor(timeline.playhead.at_s / kStepS + 1e-6);
    if (steps == 0) return 0;
    return std::min(static_cast<std::size_t>(std::max(0.0, step)), steps - 1);
}

// 1 for a receptor that fires in this step, less for one that fired in an earlier one.
std::vector<float> flashes(const Timeline& timeline, const ChannelStages& channel,
                           std::size_t step) {
    std::vector<float> flash(channel.spike_count.size(), 0.0F);
    const auto back = static_cast<std::size_t>(kFlashS / kStepS);
    for (std::size_t age = 0; age <= back && age <= step; ++age) {
        const double since_s =
            timeline.playhead.at_s - static_cast<double>(step - age) * kStepS - 0.5 * kStepS;
        const auto glow = static_cast<float>(1.0 - std::clamp(since_s / kFlashS, 0.0, 1.0));
        for (std::size_t k = 0; k < flash.size(); ++k) {
            if (channel.spike_count[k][step - age] > 0) flash[k] = std::max(flash[k], glow);
        }
    }
    return flash;
}

int total_spikes(const std::vector<int>& train) {
    int sum = 0;
    for (const int count : train) sum += count;
    return sum;
}

// Everything about one receptor; its spikes over time as a little train.
void draw_receptor_readout(Ui& ui, const Timeline& timeline, const ShownStages& shown,
                           const ReceptorPlace& place, const Rect& bounds, ImVec2 at) {
    const std::size_t c = index_of(place.type);
    const ChannelStages& channel = shown.live->neural.channel[c];
    const GridReceptor& receptor = channel.grid.receptors[place.index];
    const std::vector<int>& train = channel.spike_count[place.index];
    const double fall =
        receptor.distance_mm <= kHotZoneMm ? 1.0 : std::pow(kHotZoneMm / receptor.distance_mm, 2.0);
    std::array<std::string, 5> lines;
    lines[0] = std::string(traits(place.type).name) + ", " + significant(receptor.distance_mm) +
               " mm from the probe";
    lines[1] = "fires " + std::to_string(total_spikes(train)) + " times in " +
               tick_text(duration_s(shown.live->waveform)) + " s";
    lines[2] = std::to_string(train[step_at(timeline, shown)]) + " in these 5 ms";
    lines[3] = "rate by Eq. 2: " + significant(receptor.rate_hz) + " imp/s";
    lines[4] = "wave at " + significant(100.0 * fall) + " % of the probe's";
    draw_readout(*ImGui::GetForegroundDrawList(), ui.theme, bounds, at, lines);
    char exact[160];
    std::snprintf(exact, sizeof exact, "%s %zu %.17g %.17g %d", traits(place.type).afferent,
                  place.index, receptor.distance_mm, receptor.rate_hz, total_spikes(train));
    note_rect(ui.rects, "under the mouse:receptor", bounds.min, bounds.max, exact);
}

// The index within a type, if the place is one of its receptors.
std::optional<std::size_t> of_type(const std::optional<ReceptorPlace>& place, Receptor type) {
    if (!place || place->type != type) return std::nullopt;
    return place->index;
}

// Of the receptor under the probe, counted as the raster shows it.
std::optional<int> centre_spikes(const ChannelStages& channel) {
    const auto centre =
        std::ranges::min_element(channel.grid.receptors, {}, &GridReceptor::distance_mm);
    const auto k = static_cast<std::size_t>(centre - channel.grid.receptors.begin());
    if (k >= channel.spike_count.size()) return std::nullopt;
    return total_spikes(channel.spike_count[k]);
}

// As fired, of all types.
double largest_fired_hz(const LiveStages& live) {
    int most = 0;
    for (const ChannelStages& channel : live.neural.channel) {
        most = std::max(most, centre_spikes(channel).value_or(0));
    }
    return most / std::max(duration_s(live.waveform), 1e-3);
}

// What all maps on screen have in common: those of both patterns of a pair.
struct MapScale {
    double largest_hz = 0.0;
    double half_extent_mm = 0.0;
    double half_width_mm = 0.0;
};

MapScale map_scale(const Physiology& physiology, const LiveStages& live) {
    MapScale scale;
    const ShownDifference& pair = physiology.view.difference;
    for (const LiveStages* one : {&live, pair.a.get(), pair.b.get()}) {
        if (one == nullptr) continue;
        const auto& activation = one->neural.code.activation;
        scale.largest_hz = std::max(scale.largest_hz, largest_fired_hz(*one));
        scale.half_extent_mm = std::max(scale.half_extent_mm, common_extent_mm(activation));
        scale.half_width_mm = std::max(scale.half_width_mm, common_width_mm(activation));
    }
    return scale;
}

float eased_tilt(const Ui& ui, const Physiology& physiology) {
    const double since = ui.motion ? (ui.time_s - physiology.view.tilt_since_s) / kTiltS : 1.0;
    const auto share = static_cast<float>(std::clamp(since, 0.0, 1.0));
    return physiology.view.tilted ? share : 1.0F - share;
}

void draw_one_grid(Ui& ui, const Timeline& timeline, Physiology& physiology,
                   const ShownStages& shown, Receptor type, const Rect& area, const MapScale& scale,
                   bool large) {
    const std::size_t c = index_of(type);
    const LiveStages& live = *shown.live;
    const ChannelStages& channel = live.neural.channel[c];
    const std::vector<float> flash = flashes(timeline, channel, step_at(timeline, shown));
    ReceptorScene scene;
    scene.receptor = type;
    scene.grid = &channel.grid;
    scene.activation = live.neural.code.activation[c];
    scene.silent = channel.silent;
    scene.half_extent_mm = scale.half_extent_mm;
    scene.half_width_mm = scale.half_width_mm;
    scene.largest_hz = scale.largest_hz;
    scene.legend = !large;  // which have one for all
    scene.centre_spikes = centre_spikes(channel);
    scene.duration_s = duration_s(live.waveform);
    scene.flash = flash;
    scene.tilted = eased_tilt(ui, physiology);
    scene.selected = of_type(physiology.view.selected, type);
    scene.pointed = of_type(physiology.view.hovered_last, type);
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("grid ") + traits(type).afferent);
    const ReceptorAction action = draw_receptors(id.c_str(), ui.theme, area, scene);
    char rate[64];
    std::snprintf(rate, sizeof rate, "%.17g %zu %.17g", scene.activation.rate_hz,
                  channel.grid.activated, scene.activation.radius_mm);
    const Rect map = receptor_layout(ui.theme, area, scene).map;
    note_rect(ui.rects, id, map.min, map.max, rate);
    if (action.clicked) physiology.view.selected = ReceptorPlace{type, *action.clicked};
    if (action.clicked_empty) physiology.view.selected.reset();
    if (!action.hovered) return;
    const ReceptorPlace place{type, *action.hovered};
    physiology.view.hovered = place;
    const Rect screen{{0.0F, 0.0F}, ImGui::GetIO().DisplaySize};
    draw_receptor_readout(ui, timeline, shown, place, screen, action.hovered_at);
}

constexpr const char* kFromAbove = "From above";
constexpr const char* kTilted = "Tilted";

void draw_view_choice(Ui& ui, Physiology& physiology, ImVec2 corner) {
    ImGui::SetCursorScreenPos(corner);
    PhysiologyState& state = physiology.view;
    const auto choose = [&](const char* name, bool tilted) {
        if (draw_switch(ui, name, name, state.tilted == tilted) && state.tilted != tilted) {
            state.tilted = tilted;
            state.tilt_since_s = ui.time_s;
        }
        note_item(ui.rects, std::string("view:") + name);
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    };
    choose(kFromAbove, false);
    choose(kTilted, true);
}

// How the four maps share an area: columns and rows of them, and what each has.
struct MapGrid {
    int columns = 4;
    ImVec2 each{0, 0};
    float map_px = 0.0F;   // height of a map
    float used_px = 0.0F;  // of `each`, down to the end of its words
};

MapGrid map_grid(const Theme& theme, const Rect& area, const MapScale& scale, int columns) {
    const float gap = theme.gap_px;
    const auto across = static_cast<float>(columns);
    const float down = 4.0F / across;
    MapGrid grid{columns,
                 {(area.width() - gap * (across - 1.0F)) / across,
                  (area.height() - gap * (down - 1.0F)) / down}};
    ReceptorScene scene;
    scene.half_extent_mm = scale.half_extent_mm;
    scene.half_width_mm = scale.half_width_mm;
    const ReceptorLayout layout = receptor_layout(theme, rect_at({0.0F, 0.0F}, grid.each), scene);
    grid.map_px = layout.map.height();
    grid.used_px = std::max(layout.map.max.y, layout.caption.max.y);
    return grid;
}

// "spikes", "excite 1" ..., "inhibit 1" ...
std::vector<std::string> layer_names(const NeuralCodingParams& params) {
    std::vector<std::string> names{"spikes"};
    for (int k = 1; k <= params.excitatory_layers; ++k)
        names.push_back("excite " + std::to_string(k));
    for (int k = 1; k <= params.inhibitory_layers; ++k)
        names.push_back("inhibit " + std::to_string(k));
    return names;
}

// Of one channel, made when it is first shown in this step: large grids take milliseconds.
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

// Of what comes in there may be nothing: then that is said in `words`, else there is a legend if it
// is asked for.
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
    char exact[128];
    std::snprintf(exact, sizeof exact, "%s %zu %zu %d %d %.17g", traits(type).afferent,
                  step_at(timeline, shown), cell.layer, cell.column, cell.row, value);
    note_rect(ui.rects, "under the mouse:network", area.min, area.max, exact);
}

// Four chips to choose whose network the overview shows; what is left of their line.
Rect draw_network_choice(Ui& ui, Physiology& physiology, const Rect& area) {
    PhysiologyState& state = physiology.view;
    const float gap = 2.0F * ui.theme.scale;
    float names_px = 0.0F;
    for (const Receptor type : kReceptors) names_px += chip_width(ui, traits(type).name) + gap;
    const bool in_full = names_px <= area.width();
    const float room = (area.width() - 3.0F * gap) / 4.0F - chip_width(ui, "");
    ImGui::SetCursorScreenPos(area.min);
    for (const Receptor type : kReceptors) {
        const std::string id = std::string("network:") + traits(type).afferent;
        const char* const name = traits(type).name;
        const std::string text = in_full ? name : shortened(ui.theme.fonts.small, name, room);
        if (draw_chip(ui, id.c_str(), text.c_str(), state.network == type)) {
            state.network = type;
            state.network_chosen = true;
        }
        note_item(ui.rects, id);
        if (!in_full) draw_tooltip(ui, name);
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

float view_choice_px(const Ui& ui) {
    return chip_width(ui, kFromAbove) + chip_width(ui, kTilted) + 2.0F * ui.theme.scale;
}

void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size) {
    if (size.controls && !shown.pinned) draw_view_choice(ui, physiology, *size.controls);
    const MapScale scale = map_scale(physiology, *shown.live);
    MapGrid grid = map_grid(ui.theme, area, scale, 4);
    // Two rows where the maps are then about as large: they fill the pane.
    const MapGrid square = map_grid(ui.theme, area, scale, 2);
    if (size.large && square.map_px > 0.95F * grid.map_px) grid = square;
    // What one row leaves free is shared out above and below it.
    const float free = grid.columns == 4 ? std::max(0.0F, area.height() - grid.used_px) : 0.0F;
    const ImVec2 first = area.min + ImVec2{0.0F, std::floor(0.4F * free)};
    const ImVec2 each{grid.each.x, grid.each.y - free};
    for (const Receptor type : kReceptors) {
        const auto k = static_cast<int>(index_of(type));
        const ImVec2 place{static_cast<float>(k % grid.columns) * (each.x + ui.theme.gap_px),
                           static_cast<float>(k / grid.columns) * (each.y + ui.theme.gap_px)};
        draw_one_grid(ui, timeline, physiology, shown, type, rect_at(first + place, each), scale,
                      size.large);
    }
}

void draw_receptor_key(Ui& ui, const Physiology& physiology, const ShownStages& shown,
                       const Rect& line) {
    const double largest_hz = map_scale(physiology, *shown.live).largest_hz;
    draw_receptor_legend(*ImGui::GetWindowDrawList(), ui.theme, line, largest_hz);
    note_rect(ui.rects, "receptor key", line.min, line.max, significant(largest_hz));
}

void draw_network_key(const Ui& ui, const ShownStages& shown, const Rect& line) {
    draw_network_legend(*ImGui::GetWindowDrawList(), ui.theme, line,
                        shown.live->request.model.coding.spike_cap);
}

void draw_spike_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, const Rect& area, const StageSize& size) {
    const LiveStages& live = *shown.live;
    std::array<RasterChannel, kReceptorCount> channels;
    for (const Receptor type : kReceptors) {
        const std::size_t c = index_of(type);
        channels[c] = {type, live.neural.channel[c].spike_count, live.by_distance[c]};
    }
    const auto spot = [](const std::optional<ReceptorPlace>& place) -> std::optional<RasterSpot> {
        if (!place) return std::nullopt;
        return RasterSpot{index_of(place->type), place->index};
    };
    RasterScene scene;
    scene.channels = channels;
    scene.start_s = timeline.range.start_s;
    scene.end_s = timeline.range.end_s;
    // Large, names stand with their peaks on the left; small, beside the lanes on the right.
    if (!size.large) scene.names_px = 0.0F;
    scene.time_axis = size.time_axis;
    scene.rates = size.large;
    scene.selected = spot(physiology.view.selected);
    scene.pointed = spot(physiology.view.hovered_last);
    scene.playhead_s = timeline.playhead.at_s;
    scene.crosshair_s = timeline.crosshair_last_s;
    scene.stale = shown.stale;
    const std::string id = id_of(shown, "raster");
    const RasterAction action = draw_raster(id.c_str(), ui.theme, area, scene);
    if (!size.large && size.lanes_px > 0.0F) {
        const RasterLayout layout = raster_layout(ui.theme, area, scene);
        for (std::size_t c = 0; c < layout.bands.size(); ++c) {
            const Rect& rows = layout.bands[c].rows;
            const float half_gap = 0.375F * ui.theme.gap_px;
            draw_lane_name(ui,
                           {{area.max.x, rows.min.y - half_gap},
                            {area.max.x + size.lanes_px, rows.max.y + half_gap}},
                           channels[c].receptor);
        }
    }
    note_rect(ui.rects, "plot:" + id, area.min, area.max);
    take_time_gesture(work, timeline, area, {action.hovered_s, action.scrubbed_s});
    const auto place = [](const RasterSpot& s) {
        return ReceptorPlace{kReceptors[s.channel], s.receptor};
    };
    if (action.clicked) physiology.view.selected = place(*action.clicked);
    if (!action.hovered) return;
    physiology.view.hovered = place(*action.hovered);
    draw_receptor_readout(ui, timeline, shown, *physiology.view.hovered,
                          {{0.0F, 0.0F}, ImGui::GetIO().DisplaySize}, ImGui::GetIO().MousePos);
}

void draw_network_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                        const ShownStages& shown, const Rect& area, const StageSize& size) {
    const Theme& theme = ui.theme;
    if (!size.large) {
        PhysiologyState& state = physiology.view;
        if (!state.network_chosen) state.network = strongest_channel(*shown.live);
        Rect map = area;
        NetworkWords words;
        if (!shown.pinned) words.place = draw_network_choice(ui, physiology, area);
        // The second of a pair keeps the room of the choice, and so has the same columns.
        map.min.y += chip_height(ui) + 2.0F * theme.scale;
        return draw_one_network(ui, timeline, physiology, shown, state.network, map, words);
    }
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float gap = theme.gap_px;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Names have a column of their own: above the maps they would cost them height.
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

}  // namespace tact
