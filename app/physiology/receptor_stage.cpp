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
std::size_t step_at(const App& app, const ShownStages& shown) {
    const std::size_t steps = shown.live->neural.code.central_count[0].size();
    const double step = std::floor(app.playhead.at_s / kStepS + 1e-6);
    if (steps == 0) return 0;
    return std::min(static_cast<std::size_t>(std::max(0.0, step)), steps - 1);
}

// 1 for a receptor that fires in this step, less for one that fired in an earlier one.
std::vector<float> flashes(const App& app, const ChannelStages& channel, std::size_t step) {
    std::vector<float> flash(channel.spike_count.size(), 0.0F);
    const auto back = static_cast<std::size_t>(kFlashS / kStepS);
    for (std::size_t age = 0; age <= back && age <= step; ++age) {
        const double since_s =
            app.playhead.at_s - static_cast<double>(step - age) * kStepS - 0.5 * kStepS;
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
void draw_receptor_readout(App& app, const ShownStages& shown, const ReceptorPlace& place,
                           const Rect& bounds, ImVec2 at) {
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
    lines[2] = std::to_string(train[step_at(app, shown)]) + " in these 5 ms";
    lines[3] = "rate by Eq. 2: " + significant(receptor.rate_hz) + " imp/s";
    lines[4] = "wave at " + significant(100.0 * fall) + " % of the probe's";
    draw_readout(*ImGui::GetForegroundDrawList(), app.theme, bounds, at, lines);
    char exact[160];
    std::snprintf(exact, sizeof exact, "%s %zu %.17g %.17g %d", traits(place.type).afferent,
                  place.index, receptor.distance_mm, receptor.rate_hz, total_spikes(train));
    note_rect(app.rects, "under the mouse:receptor", bounds.min, bounds.max, exact);
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

float eased_tilt(const App& app) {
    const double since = app.motion ? (app.time_s - app.physiology.tilt_since_s) / kTiltS : 1.0;
    const auto share = static_cast<float>(std::clamp(since, 0.0, 1.0));
    return app.physiology.tilted ? share : 1.0F - share;
}

void draw_one_grid(App& app, const ShownStages& shown, Receptor type, const Rect& area,
                   double extent_mm) {
    const std::size_t c = index_of(type);
    const LiveStages& live = *shown.live;
    const ChannelStages& channel = live.neural.channel[c];
    const std::vector<float> flash = flashes(app, channel, step_at(app, shown));
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
    scene.tilted = eased_tilt(app);
    scene.selected = of_type(app.physiology.selected, type);
    scene.pointed = of_type(app.physiology.hovered_last, type);
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("grid ") + traits(type).afferent);
    const ReceptorAction action = draw_receptors(id.c_str(), app.theme, area, scene);
    char rate[64];
    std::snprintf(rate, sizeof rate, "%.17g %zu %.17g", scene.activation.rate_hz,
                  channel.grid.activated, scene.activation.radius_mm);
    note_rect(app.rects, id, area.min, area.max, rate);
    if (action.clicked) app.physiology.selected = ReceptorPlace{type, *action.clicked};
    if (action.clicked_empty) app.physiology.selected.reset();
    if (!action.hovered) return;
    const ReceptorPlace place{type, *action.hovered};
    app.physiology.hovered = place;
    const Rect screen{{0.0F, 0.0F}, ImGui::GetIO().DisplaySize};
    draw_receptor_readout(app, shown, place, screen, action.hovered_at);
}

void draw_view_choice(App& app, const Rect& area) {
    ImGui::SetCursorScreenPos(area.min);
    PhysiologyState& state = app.physiology;
    const auto choose = [&](const char* name, bool tilted) {
        if (draw_chip(app, name, name, state.tilted == tilted) && state.tilted != tilted) {
            state.tilted = tilted;
            state.tilt_since_s = app.time_s;
        }
        note_item(app.rects, std::string("view:") + name);
        ImGui::SameLine(0.0F, 2.0F * app.theme.scale);
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
const std::vector<RelayLayer>& layers_of(App& app, const ShownStages& shown, Receptor type) {
    ShownLayers& known = shown.pinned ? app.physiology.pinned_layers : app.physiology.layers;
    const std::size_t step = step_at(app, shown);
    if (known.of != shown.live || known.step != step) known = {shown.live, step, {}};
    const std::size_t c = index_of(type);
    if (known.layers[c].empty() && !shown.live->neural.code.central_count[c].empty()) {
        known.layers[c] =
            relay_layers(shown.live->neural.channel[c], step, shown.live->request.model.coding);
    }
    return known.layers[c];
}

void draw_one_network(App& app, const ShownStages& shown, Receptor type, const Rect& area) {
    const std::vector<std::string> names = layer_names(shown.live->request.model.coding);
    const std::vector<RelayLayer>& layers = layers_of(app, shown, type);
    NetworkScene scene;
    scene.layers = layers;
    scene.names = names;
    scene.cap = shown.live->request.model.coding.spike_cap;
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("network ") + traits(type).afferent);
    const NetworkAction action = draw_network(id.c_str(), app.theme, area, scene);
    note_rect(app.rects, id, area.min, area.max);
    if (!action.hovered) return;
    const NetworkCell& cell = *action.hovered;
    const double value = layers[cell.layer].at(cell.column, cell.row);
    const std::array<std::string, 3> lines{
        names[cell.layer] + ", " + traits(type).name, significant(value) + " impulses in 5 ms",
        "column " + std::to_string(cell.column) + ", row " + std::to_string(cell.row)};
    draw_readout(*ImGui::GetForegroundDrawList(), app.theme,
                 {{0.0F, 0.0F}, ImGui::GetIO().DisplaySize}, ImGui::GetIO().MousePos, lines);
    char exact[128];
    std::snprintf(exact, sizeof exact, "%s %zu %zu %d %d %.17g", traits(type).afferent,
                  step_at(app, shown), cell.layer, cell.column, cell.row, value);
    note_rect(app.rects, "under the mouse:network", area.min, area.max, exact);
}

// Four chips to choose whose network the overview shows.
Receptor chosen_network(App& app, const ShownStages& shown, const Rect& area) {
    PhysiologyState& state = app.physiology;
    if (!state.network_chosen) state.network = strongest_channel(*shown.live);
    if (shown.pinned) return state.network;
    ImGui::SetCursorScreenPos(area.min);
    for (const Receptor type : kReceptors) {
        const std::string id = std::string("network:") + traits(type).afferent;
        if (draw_chip(app, id.c_str(), traits(type).name, state.network == type)) {
            state.network = type;
            state.network_chosen = true;
        }
        note_item(app.rects, id);
        ImGui::SameLine(0.0F, 2.0F * app.theme.scale);
    }
    return state.network;
}

float chip_height(const App& app) {
    return font_or_current(app.theme.fonts.small).FontSize + 8.0F * app.theme.scale;
}

}  // namespace

void draw_receptor_stage(App& app, const ShownStages& shown, const Rect& area,
                         const StageSize& size) {
    const double extent_mm = common_extent_mm(shown.live->neural.code.activation);
    Rect maps = area;
    if (size.large && !shown.pinned && !app.as_picture) {
        draw_view_choice(app, area);
        maps.min.y += chip_height(app);
    }
    // Two rows where the pane is taller than four maps in one would use.
    const bool square = size.large && maps.height() > 0.75F * maps.width();
    const int columns = square ? 2 : 4;
    const int rows = 4 / columns;
    const float gap = app.theme.gap_px;
    const ImVec2 each{
        (maps.width() - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns),
        (maps.height() - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows)};
    for (const Receptor type : kReceptors) {
        const auto k = static_cast<int>(index_of(type));
        const ImVec2 corner{maps.min.x + static_cast<float>(k % columns) * (each.x + gap),
                            maps.min.y + static_cast<float>(k / columns) * (each.y + gap)};
        draw_one_grid(app, shown, type, rect_at(corner, each), extent_mm);
    }
}

void draw_spike_stage(App& app, const ShownStages& shown, const Rect& area, const StageSize& size) {
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
    scene.start_s = app.time_range.start_s;
    scene.end_s = app.time_range.end_s;
    // The names take more room than values do; small, the colours say it.
    if (!size.large) scene.names_px = 0.0F;
    scene.time_axis = size.time_axis;
    scene.rates = size.large;
    scene.selected = spot(app.physiology.selected);
    scene.pointed = spot(app.physiology.hovered_last);
    scene.playhead_s = app.playhead.at_s;
    scene.crosshair_s = app.crosshair_last_s;
    scene.stale = shown.stale;
    const std::string id = id_of(shown, "raster");
    const RasterAction action = draw_raster(id.c_str(), app.theme, area, scene);
    note_rect(app.rects, "plot:" + id, area.min, area.max);
    take_time_gesture(app, area, {action.hovered_s, action.scrubbed_s});
    const auto place = [](const RasterSpot& s) {
        return ReceptorPlace{kReceptors[s.channel], s.receptor};
    };
    if (action.clicked) app.physiology.selected = place(*action.clicked);
    if (!action.hovered) return;
    app.physiology.hovered = place(*action.hovered);
    draw_receptor_readout(app, shown, *app.physiology.hovered,
                          {{0.0F, 0.0F}, ImGui::GetIO().DisplaySize}, ImGui::GetIO().MousePos);
}

void draw_network_stage(App& app, const ShownStages& shown, const Rect& area,
                        const StageSize& size) {
    if (!size.large) {
        const Receptor type = chosen_network(app, shown, area);
        Rect map = area;
        map.min.y += shown.pinned ? 0.0F : chip_height(app);
        return draw_one_network(app, shown, type, map);
    }
    const float gap = app.theme.gap_px;
    const float height = (area.height() - 3.0F * gap) / 4.0F;
    for (const Receptor type : kReceptors) {
        const float top = area.min.y + static_cast<float>(index_of(type)) * (height + gap);
        const float name = font_or_current(app.theme.fonts.small).FontSize;
        draw_text(*ImGui::GetWindowDrawList(), app.theme.fonts.small, {area.min.x, top},
                  app.theme.receptor[index_of(type)], traits(type).name);
        draw_one_network(app, shown, type, {{area.min.x, top + name}, {area.max.x, top + height}});
    }
}

}  // namespace tact
