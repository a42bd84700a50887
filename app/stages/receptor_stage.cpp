#include "app/stages/parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/document/editing.h"
#include "app/timeline/timeline.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/spectrum_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/skin/raster_view.h"
#include "viz/skin/receptor_caption.h"
#include "viz/skin/receptor_view.h"

namespace tact {

// The receptors of each type in the skin, from above or tilted.

namespace {

constexpr double kTiltS = 0.18;
// Time in which a flash fades: three steps of the model.
constexpr double kFlashS = 0.015;

// 1 for a receptor that fires in this step, less for an earlier spike.
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

// The index within a type, if the place is one of its receptors.
std::optional<std::size_t> of_type(const std::optional<ReceptorPlace>& place, Receptor type) {
    if (!place || place->type != type) return std::nullopt;
    return place->index;
}

// Spikes of the receptor under the probe, counted as in the raster.
std::optional<int> centre_spikes(const ChannelStages& channel) {
    const auto centre =
        std::ranges::min_element(channel.grid.receptors, {}, &GridReceptor::distance_mm);
    const auto k = static_cast<std::size_t>(centre - channel.grid.receptors.begin());
    if (k >= channel.spike_count.size()) return std::nullopt;
    return total_spikes(channel.spike_count[k]);
}

// The largest firing rate at the centre over all types.
double largest_fired_hz(const LiveStages& live) {
    int most = 0;
    for (const ChannelStages& channel : live.neural.channel) {
        most = std::max(most, centre_spikes(channel).value_or(0));
    }
    return most / std::max(duration_s(live.waveform), 1e-3);
}

// Scales shared by all maps on screen, including both patterns of a pair.
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
    scene.legend = !large;  // which have one for all maps
    scene.centre_spikes = centre_spikes(channel);
    scene.duration_s = duration_s(live.waveform);
    scene.only_leaks = live.firing[c] == Firing::leaks;
    const double times = scene.only_leaks ? 0.0 : live.impulses_a_cycle[c];
    scene.times_a_cycle = times > kManyACycle ? times : 0.0;
    scene.flash = flash;
    scene.tilted = eased_tilt(ui, physiology);
    scene.selected = of_type(physiology.view.selected, type);
    scene.pointed = of_type(physiology.view.hovered_last, type);
    scene.stale = shown.stale;
    const std::string id = id_of(shown, std::string("grid ") + traits(type).afferent);
    const ReceptorAction action = draw_receptors(id.c_str(), ui.theme, area, scene);
    const std::string rate = shortest_digits(scene.activation.rate_hz) + " " +
                             std::to_string(channel.grid.activated) + " " +
                             shortest_digits(scene.activation.radius_mm);
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
        const bool chosen = state.tilted == tilted;
        if (toggle(ui, {.id = std::string("view:") + name, .label = name}, chosen) && !chosen) {
            state.tilted = tilted;
            state.tilt_since_s = ui.time_s;
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    };
    choose(kFromAbove, false);
    choose(kTilted, true);
}

// Layout of the four maps in an area: columns, rows, and the size of a cell.
struct MapGrid {
    int columns = 4;
    ImVec2 each{0, 0};
    float map_px = 0.0F;   // height of a map
    float used_px = 0.0F;  // part of `each`, including its words
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

}  // namespace

float view_choice_px(const Ui& ui) {
    return chip_width(ui, kFromAbove) + chip_width(ui, kTilted) + 2.0F * ui.theme.scale;
}

void draw_receptor_stage(Ui& ui, const Timeline& timeline, Physiology& physiology,
                         const ShownStages& shown, const Rect& area, const StageSize& size) {
    if (size.controls && !shown.pinned) draw_view_choice(ui, physiology, *size.controls);
    const MapScale scale = map_scale(physiology, *shown.live);
    MapGrid grid = map_grid(ui.theme, area, scale, 4);
    // Two rows if the maps are about as large as in one: they fill the pane.
    const MapGrid square = map_grid(ui.theme, area, scale, 2);
    if (size.large && square.map_px > 0.95F * grid.map_px) grid = square;
    // Room that a single row leaves is split above and below it.
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

std::string id_of(const ShownStages& shown, const std::string& name) {
    return shown.pinned ? name + " pinned" : name;
}

std::size_t step_at(const Timeline& timeline, const ShownStages& shown) {
    const std::size_t steps = shown.live->neural.code.central_count[0].size();
    const double step = std::floor(timeline.playhead.at_s / kStepS + 1e-6);
    if (steps == 0) return 0;
    return std::min(static_cast<std::size_t>(std::max(0.0, step)), steps - 1);
}

int total_spikes(const std::vector<int>& train) {
    int sum = 0;
    for (const int count : train) sum += count;
    return sum;
}

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
    const bool leaks = shown.live->firing[c] == Firing::leaks;
    lines[1] = (leaks ? "filter leak: " : "fires ") + std::to_string(total_spikes(train)) +
               " times in " + tick_text(duration_s(shown.live->waveform)) + " s";
    lines[2] = std::to_string(train[step_at(timeline, shown)]) + " in these 5 ms";
    lines[3] = "rate by Eq. 2: " + significant(receptor.rate_hz) + " imp/s";
    lines[4] = "wave at " + significant(100.0 * fall) + " % of the probe's";
    draw_readout(*ImGui::GetForegroundDrawList(), ui.theme, bounds, at, lines);
    const std::string exact =
        std::string(traits(place.type).afferent) + " " + std::to_string(place.index) + " " +
        shortest_digits(receptor.distance_mm) + " " + shortest_digits(receptor.rate_hz) + " " +
        std::to_string(total_spikes(train));
    note_rect(ui.rects, "under the mouse:receptor", bounds.min, bounds.max, exact);
}

// Spikes of all receptors over time.

void draw_spike_stage(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                      const ShownStages& shown, const Rect& area, const StageSize& size) {
    const LiveStages& live = *shown.live;
    std::array<RasterChannel, kReceptorCount> channels;
    for (const Receptor type : kReceptors) {
        const std::size_t c = index_of(type);
        channels[c] = {type, live.neural.channel[c].spike_count, live.by_distance[c],
                       live.only_leaks[c]};
        if (size.large) channels[c].note = firing_note(live, type);
        channels[c].pale_steps = live.silent_steps[c];
    }
    const auto spot = [](const std::optional<ReceptorPlace>& place) -> std::optional<RasterSpot> {
        if (!place) return std::nullopt;
        return RasterSpot{index_of(place->type), place->index};
    };
    RasterScene scene;
    scene.channels = channels;
    const TimeRange range = shown_range(timeline, shown_duration_s(work));
    scene.start_s = range.start_s;
    scene.end_s = range.end_s;
    // In the large stage, names stand with their peaks at the left; in the small one, beside the
    // lanes at the right.
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

// Components over thresholds; in the large spectrum the thresholds can be moved.

void draw_spectrum_stage(Ui& ui, Physiology& physiology, const ShownStages& shown, const Rect& area,
                         bool large) {
    SpectrumScene scene;
    scene.components = shown.live->neural.components;
    scene.thresholds = &shown.live->request.model.coding.tables.threshold;
    scene.ghosts = &default_tables().threshold;
    scene.colour = ui.theme.text;
    scene.stale = shown.stale;
    scene.curves_move = large && !shown.pinned && !ui.as_picture;
    const MeasuredSpectrum measured = measured_spectrum(physiology);
    scene.felt_db = measured.felt_db;
    scene.bands = measured.bands;
    const char* id = shown.pinned ? "spectrum pinned" : "spectrum";
    const SpectrumAction action = draw_spectrum(id, ui.theme, area, scene);
    note_rect(ui.rects, std::string("plot:") + id, area.min, area.max);
    if (action.taken) {
        physiology.view.threshold_move = {*action.taken, action.moved_db, action.released};
    }
    if (!action.hovered) return;
    const Component& component = scene.components[*action.hovered];
    const std::string text =
        shortest_digits(component.frequency_hz) + " " + shortest_digits(component.skin_um);
    note_rect(ui.rects, std::string("under the mouse:") + id, area.min, area.max, text);
}

}  // namespace tact
