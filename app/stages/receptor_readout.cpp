#include "app/stages/receptor_readout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

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

}  // namespace tact
