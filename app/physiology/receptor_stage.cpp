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

float eased_tilt(const Ui& ui, const Physiology& physiology) {
    const double since = ui.motion ? (ui.time_s - physiology.view.tilt_since_s) / kTiltS : 1.0;
    const auto share = static_cast<float>(std::clamp(since, 0.0, 1.0));
    return physiology.view.tilted ? share : 1.0F - share;
}

void draw_one_grid(Ui& ui, const Timeline& timeline, Physiology& physiology,
                   const ShownStages& shown, Receptor type, const Rect& area, double extent_mm) {
    const std::size_t c = index_of(type);
    const LiveStages& live = *shown.live;
    const ChannelStages& channel = live.neural.channel[c];
    const std::vector<float> flash = flashes(timeline, channel, step_at(timeline, shown));
    ReceptorScene scene;
    scene.receptor = type;
    scene.grid = &channel.grid;
    scene.activation = live.neural.code.activation[c];
    scene.silent = channel.silent;
    scene.half_extent_mm = extent_mm;
    scene.largest_hz = largest_fired_hz(live);
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
    note_rect(ui.rects, id, area.min, area.max, rate);
    if (action.clicked) physiology.view.selected = ReceptorPlace{type, *action.clicked};
    if (action.clicked_empty) physiology.view.selected.reset();
    if (!action.hovered) return;
    const ReceptorPlace place{type, *action.hovered};
    physiology.view.hovered = place;
    const Rect screen{{0.0F, 0.0F}, ImGui::GetIO().DisplaySize};
    draw_receptor_readout(ui, timeline, shown, place, screen, action.hovered_at);
}

void draw_view_choice(Ui& ui, Physiology& physiology, const Rect& area) {
    ImGui::SetCursorScreenPos(area.min);
    PhysiologyState& state = physiology.view;
    const auto choose = [&](const char* name, bool tilted) {
        if (draw_switch(ui, name, name, state.tilted == tilted) && state.tilted != tilted) {
            state.tilted = tilted;
            state.tilt_since_s = ui.time_s;
        }
        note_item(ui.rects, std::string("view:") + name);
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    };
    choose("From above", false);
    choose("Tilted", true);
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

void draw_one_network(Ui& ui, const Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, Receptor type, const Rect& area) {
    const std::vector<std::string> names = layer_names(shown.live->request.model.coding);
    const std::vector<RelayLayer>& layers = layers_of(timeline, physiology, shown, type);
    NetworkScene scene;
    scene.layers = layers;
    scene.names = names;
    scene.cap = shown.live->request.model.coding.spike_cap;
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("network ") + traits(type).afferent);
    const NetworkAction action = draw_network(id.c_str(), ui.theme, area, scene);
    note_rect(ui.rects, id, area.min, area.max);
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

// Four chips to choose whose network the overview shows.
Receptor chosen_network(Ui& ui, Physiology& physiology, const ShownStages& shown,
                        const Rect& area) {
    PhysiologyState& state = physiology.view;
    if (!state.network_chosen) state.network = strongest_channel(*shown.live);
    if (shown.pinned) return state.network;
    const float gap = 2.0F * ui.theme.scale;
    float names_px = 0.0F;
    for (const Receptor type : kReceptors) names_px += chip_width(ui, traits(type).name) + gap;
    const bool in_full = names_px <= area.width();
    ImGui::SetCursorScreenPos(area.min);
    for (const Receptor type : kReceptors) {
        const std::string id = std::string("network:") + traits(type).afferent;
        const char* const name = in_full ? traits(type).name : traits(type).afferent;
        if (draw_chip(ui, id.c_str(), name, state.network == type)) {
            state.network = type;
            state.network_chosen = true;
        }
        note_item(ui.rects, id);
        if (!in_full) draw_tooltip(ui, traits(type).name);
        ImGui::SameLine(0.0F, gap);
    }
    return state.network;
}

float chip_height(const Ui& ui) {
    return font_or_current(ui.theme.fonts.small).FontSize + 8.0F * ui.theme.scale;
}

}  // namespace

void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size) {
    const double extent_mm = common_extent_mm(shown.live->neural.code.activation);
    Rect maps = area;
    if (size.large && !shown.pinned && !ui.as_picture) {
        draw_view_choice(ui, physiology, area);
        maps.min.y += chip_height(ui);
    }
    // Two rows where the maps are then about as large: they fill the pane.
    const float caption = 4.0F * font_or_current(ui.theme.fonts.small).FontSize;
    const float in_one = std::min(maps.width() / 4.0F, maps.height() - caption);
    const float in_two = std::min(maps.width() / 2.0F, maps.height() / 2.0F - caption);
    const bool square = size.large && in_two > 0.8F * in_one;
    const int columns = square ? 2 : 4;
    const int rows = 4 / columns;
    const float gap = ui.theme.gap_px;
    const ImVec2 each{
        (maps.width() - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns),
        (maps.height() - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows)};
    for (const Receptor type : kReceptors) {
        const auto k = static_cast<int>(index_of(type));
        const ImVec2 corner{maps.min.x + static_cast<float>(k % columns) * (each.x + gap),
                            maps.min.y + static_cast<float>(k / columns) * (each.y + gap)};
        draw_one_grid(ui, timeline, physiology, shown, type, rect_at(corner, each), extent_mm);
    }
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
    // The names take more room than values do; small, the colours say it.
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
    if (!size.large) {
        const Receptor type = chosen_network(ui, physiology, shown, area);
        Rect map = area;
        map.min.y += shown.pinned ? 0.0F : chip_height(ui);
        return draw_one_network(ui, timeline, physiology, shown, type, map);
    }
    const float gap = ui.theme.gap_px;
    const float height = (area.height() - 3.0F * gap) / 4.0F;
    for (const Receptor type : kReceptors) {
        const float top = area.min.y + static_cast<float>(index_of(type)) * (height + gap);
        const float name = font_or_current(ui.theme.fonts.small).FontSize;
        draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, {area.min.x, top},
                  ui.theme.receptor[index_of(type)], traits(type).name);
        draw_one_network(ui, timeline, physiology, shown, type,
                         {{area.min.x, top + name}, {area.max.x, top + height}});
    }
}

}  // namespace tact
