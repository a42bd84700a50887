#include "app/timeline/timeline.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

Playhead advanced(Playhead playhead, double elapsed_s, double duration_s) {
    if (!playhead.playing) return playhead;
    playhead.at_s += std::max(0.0, elapsed_s) * playhead.speed;
    if (playhead.at_s < duration_s) return playhead;
    if (playhead.loop && duration_s > 0.0) {
        playhead.at_s = std::fmod(playhead.at_s, duration_s);
    } else {
        playhead.at_s = duration_s;
        playhead.playing = false;
    }
    return playhead;
}

Playhead stepped(Playhead playhead, int steps, double duration_s) {
    // A playhead that stands on a step's start belongs to that step, whatever the rounding.
    const double own = std::floor(playhead.at_s / kStepS + 1e-6);
    const double last = std::max(0.0, std::ceil(duration_s / kStepS - 1e-6) - 1.0);
    playhead.at_s = std::clamp(own + steps, 0.0, last) * kStepS;
    playhead.playing = false;
    return playhead;
}

namespace {

// Left of the curves where a large view has values: enough for "-0.0025".
constexpr float kValueRoomPx = 52.0F;

}  // namespace

float value_room_px(const Ui& ui) { return kValueRoomPx * ui.theme.scale; }

float time_axis_height(const Ui& ui) {
    return ui.theme.fonts.small->FontSize + ui.theme.gap_px * 0.75F;
}

void take_time_gesture(const Workspace& work, Timeline& timeline, const Rect& area,
                       const TimeGesture& gesture) {
    if (gesture.scrubbed_s) timeline.playhead.at_s = *gesture.scrubbed_s;
    if (!gesture.hovered_s) return;
    timeline.crosshair_s = gesture.hovered_s;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0.0F && io.MouseWheelH == 0.0F) return;
    ImGui::SetItemUsingMouseWheel();
    const double duration_s = shown_duration_s(work);
    const TimeRange shown = shown_range(timeline, duration_s);
    if (io.KeyCtrl) {
        const double factor = std::pow(1.25, -static_cast<double>(io.MouseWheel));
        timeline.range =
            unless_whole(zoomed(shown, factor, *gesture.hovered_s, duration_s), duration_s);
        return;
    }
    const double per_px = shown.length_s() / std::max(1.0, static_cast<double>(area.width()));
    const double by_px = 60.0 * static_cast<double>(io.MouseWheelH - io.MouseWheel);
    timeline.range = unless_whole(panned(shown, by_px * per_px, duration_s), duration_s);
}

void draw_time_row(Ui& ui, const Workspace& work, Timeline& timeline, const Rect& area,
                   const TimeRow& row) {
    const WaveTrace trace{row.samples, row.rate_hz, row.colour, row.style};
    WaveScene scene;
    scene.traces = {&trace, 1};
    const TimeRange range = shown_range(timeline, shown_duration_s(work));
    scene.start_s = range.start_s;
    scene.end_s = range.end_s;
    scene.largest = row.largest;
    scene.signed_values = row.signed_values;
    scene.unit = row.unit;
    scene.time_axis = row.time_axis;
    scene.value_axis = row.large && row.values;
    scene.left_room_px = row.large ? kValueRoomPx * ui.theme.scale : 0.0F;
    scene.playhead_s = timeline.playhead.at_s;
    scene.crosshair_s = timeline.crosshair_last_s;
    scene.stale = row.stale;
    const WaveAction action = draw_wave(row.id.c_str(), ui.theme, area, scene);
    note_rect(ui.rects, "plot:" + row.id, area.min, area.max);
    if (action.hovered_sample) {
        const std::size_t sample = *action.hovered_sample;
        note_rect(ui.rects, "under the mouse:" + row.id, area.min, area.max,
                  std::to_string(sample) + " " + shortest_digits(row.samples[sample]));
    }
    take_time_gesture(work, timeline, area, {action.hovered_s, action.scrubbed_s});
}

}  // namespace tact
