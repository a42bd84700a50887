#include "viz/skin/firing_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "model/physiology/spike_train.h"
#include "model/signal/waveform.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr double kWindowS = static_cast<double>(kWindowSamples) / kModelRateHz;

// Every second window has a background of its own: at its end the energy is compared.
void draw_windows(ImDrawList& list, const Theme& theme, const Plot& plot) {
    const auto first = static_cast<int>(std::floor(plot.x.low / kWindowS));
    const auto last = static_cast<int>(std::ceil(plot.x.high / kWindowS));
    for (int window = first; window < last; ++window) {
        if (window % 2 != 0) continue;
        const double from_s = std::max(window * kWindowS, plot.x.low);
        const double to_s = std::min((window + 1) * kWindowS, plot.x.high);
        list.AddRectFilled({to_pixel(plot.x, from_s), plot.area.min.y},
                           {to_pixel(plot.x, to_s), plot.area.max.y}, faded(theme.line, 0.35F));
    }
}

void draw_threshold_line(ImDrawList& list, const Theme& theme, const Plot& plot) {
    const float y = to_pixel(plot.y, 1.0);
    draw_level_line(list, y, plot.area.min.x, plot.area.max.x, theme.hairline_px, theme.text);
    const std::string_view name = "threshold";
    const ImVec2 size = text_size(theme.fonts.small, name);
    draw_text_halo(list, theme.fonts.small,
                   {plot.area.max.x - size.x - theme.gap_px, y - size.y - theme.hairline_px},
                   theme.text, theme.pane, 2.0F * theme.scale, name);
}

void draw_spikes(ImDrawList& list, const Theme& theme, const Plot& plot, const FiringScene& scene,
                 ImU32 colour) {
    for (std::size_t step = 0; step < scene.spikes.size(); ++step) {
        for (const std::size_t offset : spread_spikes(scene.spikes[step])) {
            const double at_s = static_cast<double>(step * kStepSamples + offset) / kModelRateHz;
            if (at_s < scene.start_s || at_s > scene.end_s) continue;
            draw_upright_line(list, to_pixel(plot.x, at_s), plot.area.min.y, plot.area.max.y,
                              theme.trace_px, colour);
        }
    }
}

double largest_of(std::span<const double> values, const FiringScene& scene) {
    double largest = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double at_s = static_cast<double>(n) / kModelRateHz;
        if (at_s < scene.start_s || at_s > scene.end_s) continue;
        largest = std::max(largest, std::abs(values[n]));
    }
    return largest > 0.0 ? largest : 1.0;
}

// Shares of the height for the rows, each below its own title.
template <std::size_t N>
std::array<Rect, N> rows_in(const Theme& theme, const Rect& area, const std::array<float, N>& parts,
                            const std::array<std::string, N>& titles) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float title_px = text_size(theme.fonts.small, "L").y + 0.5F * theme.gap_px;
    const float each_px = title_px + theme.gap_px;
    float sum = 0.0F;
    for (const float part : parts) sum += part;
    const float shared_px = std::max(area.height() - static_cast<float>(N) * each_px, 1.0F);
    std::array<Rect, N> rows;
    float top = area.min.y;
    for (std::size_t k = 0; k < N; ++k) {
        draw_text(list, theme.fonts.small, {area.min.x, top}, theme.dim_text, titles[k]);
        const float bottom = top + title_px + shared_px * parts[k] / sum;
        rows[k] = {{area.min.x, top + title_px}, {area.max.x, bottom}};
        top = bottom + theme.gap_px;
    }
    return rows;
}

}  // namespace

std::vector<double> energy_since_spike(std::span<const double> perceived, double fires) {
    const std::vector<double> fractions = energy_fractions(perceived);
    double whole = 0.0;
    for (const double value : perceived) whole += value * value;
    std::vector<double> since(perceived.size(), 0.0);
    if (whole == 0.0) return since;
    double energy = 0.0;
    double fired = 0.0;
    for (std::size_t n = 0; n < perceived.size(); ++n) {
        energy += perceived[n] * perceived[n];
        const bool ends_window = (n + 1) % kWindowSamples == 0 || n + 1 == perceived.size();
        // Counted as spikes are: at the end of a window, with 1e-9 added so that whole numbers stay
        // whole.
        if (ends_window) fired = std::floor(fires * fractions[n / kWindowSamples] + 1e-9);
        since[n] = std::max(fires * (energy / whole) - fired, 0.0);
    }
    return since;
}

std::pair<double, double> telling_time_s(std::span<const int> spikes) {
    constexpr int kSpikes = 12;
    constexpr double kLeastS = 0.1;
    const double whole_s = static_cast<double>(spikes.size()) * kStepS;
    std::size_t first = 0;
    while (first < spikes.size() && spikes[first] == 0) ++first;
    if (first == spikes.size()) return {0.0, std::min(kLeastS, whole_s)};
    std::size_t last = first;
    for (int seen = 0; last < spikes.size() && seen < kSpikes; ++last) seen += spikes[last];
    // Starts one window before the first spike, so that the energy is seen to grow.
    const double from_s =
        std::max(std::floor(static_cast<double>(first) * kStepS / kWindowS) - 1.0, 0.0) * kWindowS;
    const double to_s = std::ceil(static_cast<double>(last) * kStepS / kWindowS) * kWindowS;
    return {from_s, std::min(std::max(to_s, from_s + kLeastS), std::max(whole_s, kLeastS))};
}

void draw_firing(const Theme& theme, const Rect& area, const FiringScene& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 colour = theme.receptor[index_of(scene.receptor)];
    const bool changes = traits(scene.receptor).rapidly_adapting;
    const std::array<std::string, 3> titles{
        changes ? "Perceived: the change of the filtered vibration"
                : "Perceived: the filtered vibration",
        "Energy since the last spike, in thresholds; looked at when a window of 10 ms ends",
        "Spikes"};
    const auto rows = rows_in(theme, area, std::array{4.0F, 4.0F, 1.5F}, titles);
    const std::vector<double> since = energy_since_spike(scene.perceived, scene.fires);
    const double reach = largest_of(scene.perceived, scene);
    const double most = std::max(1.2, 1.08 * largest_of(since, scene));
    const std::array<Axis, 3> values{Axis{-1.05 * reach, 1.05 * reach}, Axis{0.0, most},
                                     Axis{0.0, 1.0}};
    const PlotLabels bare{.x_unit = "", .y_unit = "", .y_grid = false};
    const PlotLabels with_numbers{.x_unit = "", .y_unit = "", .y_grid = true};
    const PlotLabels with_time{.x_unit = "s", .y_unit = "", .y_grid = false};
    const Axis time{scene.start_s, scene.end_s};
    std::array<Plot, 3> plots{plot_within(rows[0], theme, time, values[0], bare),
                              plot_within(rows[1], theme, time, values[1], with_numbers),
                              plot_within(rows[2], theme, time, values[2], with_time)};
    for (Plot& plot : plots) {
        plot.area.min.x = plot.x.low_px = plots[1].area.min.x;
        draw_windows(list, theme, plot);
    }
    draw_zero_line(list, theme, plots[0]);
    draw_signal(list, theme, plots[0], scene.perceived, kModelRateHz, colour, TraceStyle::line);
    draw_axes(list, theme, plots[1], with_numbers);
    draw_signal(list, theme, plots[1], since, kModelRateHz, colour, TraceStyle::line);
    draw_threshold_line(list, theme, plots[1]);
    draw_axes(list, theme, plots[2], with_time);
    draw_spikes(list, theme, plots[2], scene, colour);
}

}  // namespace tact
