// Spikes of all receptors over time.

#include <array>

#include "app/document/editing.h"
#include "app/stages/receptor_readout.h"
#include "app/stages/stage_pictures.h"
#include "app/stages/stage_remarks.h"
#include "app/timeline/time_rows.h"
#include "viz/skin/raster_view.h"

namespace tact {

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

}  // namespace tact
