#include "app/pictures/pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "app/pictures/parts.h"
#include "app/rendering/rendering.h"
#include "model/physiology/firing.h"
#include "model/physiology/neural_coding.h"
#include "model/text/numbers.h"
#include "viz/charts/response_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/skin/firing_view.h"

namespace tact {

namespace {

// The least and largest value of all curves, in whole multiples of a step.
Range span_of(const PerReceptor<Curve>& curves, double step) {
    Range span{0.0, step};
    for (const Curve& curve : curves) {
        for (const double value : curve.value) {
            span.low = std::min(span.low, step * std::floor(value / step));
            span.high = std::max(span.high, step * std::ceil(value / step));
        }
    }
    return span;
}

// A mark and a name each, on one line; what is left below it.
Rect draw_type_legend(const Theme& theme, const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line_px = text_size(theme.fonts.small, "L").y;
    float x = area.min.x;
    for (const Receptor receptor : kReceptors) {
        const std::string name =
            std::string(traits(receptor).name) + " (" + traits(receptor).afferent + ")";
        const float middle = area.min.y + 0.5F * line_px;
        draw_receptor_mark(list, theme, {x + theme.mark_px, middle}, theme.mark_px, receptor);
        x += 2.0F * theme.mark_px + 0.5F * theme.gap_px;
        draw_text(list, theme.fonts.small, {x, area.min.y}, theme.text, name);
        x += text_size(theme.fonts.small, name).x + 2.0F * theme.gap_px;
    }
    draw_text(list, theme.fonts.small, {x, area.min.y}, theme.dim_text, "dashed: beyond its band");
    return {{area.min.x, area.min.y + line_px + 1.5F * theme.gap_px}, area.max};
}

void draw_table(const Theme& theme, const Rect& area, const char* title,
                const ReceptorCurves& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, theme.fonts.regular, area.min, theme.text, title);
    const float title_px = text_size(theme.fonts.regular, "L").y + theme.gap_px;
    draw_receptor_curves(theme, {{area.min.x, area.min.y + title_px}, area.max}, scene);
}

int spikes_of(const ChannelStages& channel) {
    const std::span<const int> spikes = spikes_under_probe(channel);
    return std::accumulate(spikes.begin(), spikes.end(), 0);
}

// What a filter only leaks is no firing to be shown, unless there is no other.
Receptor most_firing(const NeuralCodingStages& stages, const NeuralCodingParams& params) {
    const PerReceptor<Firing> firing = firing_of(stages, params);
    return *std::ranges::max_element(kReceptors, {}, [&](Receptor receptor) {
        const std::size_t c = index_of(receptor);
        return std::pair(firing[c] == Firing::fires, spikes_of(stages.channel[c]));
    });
}

double fires_under_probe(const ChannelStages& channel) {
    for (const GridReceptor& receptor : channel.grid.receptors) {
        if (receptor.column == 0 && receptor.row == 0) return receptor.fires;
    }
    return 0.0;
}

}  // namespace

Picture tables_picture(const PhysiologyTables& tables, const PictureSize& size) {
    const bool is_own = tables != default_tables();
    const std::string detail =
        is_own ? "tables of this set"
               : "rebuilt from published data: not the values of the publication";
    return drawn(size, options_of(size, detail), [&](const Theme& theme) {
        const Rect rest =
            draw_type_legend(theme, draw_title(theme, "Tables of the four types", detail));
        const float middle = rest.centre().x;
        const float half_gap = 1.5F * theme.gap_px;
        draw_table(
            theme, {rest.min, {middle - half_gap, rest.max.y}},
            "Slope of the rate over log amplitude",
            {&tables.slope, {1.0, 500.0}, span_of(tables.slope, 100.0), "impulses/s per log10 µm"});
        draw_table(
            theme, {{middle + half_gap, rest.min.y}, rest.max}, "Absolute threshold",
            {&tables.threshold, {1.0, 500.0}, span_of(tables.threshold, 0.5), "log10 µm peak"});
    });
}

Picture firing_picture(const Vibration& vibration, const NeuralCodingParams& params,
                       const PictureSize& size) {
    const NeuralCodingStages stages =
        neural_coding_stages(waveform_of(vibration), params, KeepLayers::none);
    const Receptor receptor = most_firing(stages, params);
    const ChannelStages& channel = stages.channel[index_of(receptor)];
    FiringScene scene{.receptor = receptor,
                      .perceived = channel.perceived,
                      .spikes = spikes_under_probe(channel),
                      .fires = fires_under_probe(channel)};
    std::tie(scene.start_s, scene.end_s) = telling_time_s(scene.spikes);
    const int spikes = spikes_of(channel);
    const std::string detail = std::string("the ") + traits(receptor).name +
                               " receptor under the probe, " + std::to_string(spikes) +
                               (spikes == 1 ? " spike in " : " spikes in ") +
                               significant(duration_s(waveform_of(vibration))) + " s";
    return drawn(size, options_of(size, vibration.name + detail), [&](const Theme& theme) {
        draw_firing(theme, draw_title(theme, vibration.name, detail), scene);
    });
}

}  // namespace tact
