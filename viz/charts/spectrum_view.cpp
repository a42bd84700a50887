#include "viz/charts/spectrum_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "model/common/units.h"
#include "model/text/numbers.h"
#include "viz/charts/response_view.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {
namespace {

constexpr PlotLabels kLabels{.x_unit = "Hz", .y_unit = "dB re 1 µm"};

// The range shows every threshold, and every component that comes near one.
Axis level_axis(const SpectrumScene& scene) {
    Axis axis{.low = 1e9, .high = -1e9};
    for (const Curve& threshold : *scene.thresholds) {
        if (threshold_db(threshold, kLowestComponentHz) >= kOutOfReachDb) continue;
        for (double f = kLowestComponentHz; f <= kHighestComponentHz; f *= 1.25) {
            axis.low = std::min(axis.low, threshold_db(threshold, f));
            axis.high = std::max(axis.high, threshold_db(threshold, f));
        }
    }
    for (const Component& c : scene.components) axis.high = std::max(axis.high, level_db(c));
    axis.low = 10.0 * std::floor(axis.low / 10.0 - 1.0);
    axis.high = 10.0 * std::ceil(axis.high / 10.0);
    return axis;
}

double lowest_threshold_db(const SpectrumScene& scene, double frequency_hz) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Curve& threshold : *scene.thresholds) {
        lowest = std::min(lowest, threshold_db(threshold, frequency_hz));
    }
    return lowest;
}

void draw_bar(ImDrawList& list, const Theme& theme, const Plot& plot, const SpectrumScene& scene,
              const Component& c, bool hovered) {
    const double level = level_db(c);
    if (level < plot.y.low) return;
    const double felt_from = std::max(plot.y.low, lowest_threshold_db(scene, c.frequency_hz));
    const double silent_to = std::min(level, felt_from);
    const auto bar = [&](float width_px, double from, double to, ImU32 colour) {
        const float left = to_pixel(plot.x, c.frequency_hz) - width_px / 2.0F;
        list.AddRectFilled({left, to_pixel(plot.y, to)}, {left + width_px, to_pixel(plot.y, from)},
                           colour);
    };
    bar(1.5F * theme.scale, plot.y.low, silent_to, faded(theme.dim_text, hovered ? 0.9F : 0.4F));
    if (level <= felt_from) return;
    bar(2.5F * theme.scale, felt_from, level, hovered ? theme.accent : scene.colour);
}

// Marks where the strongest components cross a type's threshold: the types that feel them.
void draw_crossings(ImDrawList& list, const Theme& theme, const Plot& plot,
                    const SpectrumScene& scene) {
    double strongest = -1e9;
    for (const Component& c : scene.components) strongest = std::max(strongest, c.amplitude_g);
    for (const Component& c : scene.components) {
        if (c.amplitude_g < 0.5 * strongest) continue;
        for (const Receptor receptor : kReceptors) {
            const double db = threshold_db((*scene.thresholds)[index_of(receptor)], c.frequency_hz);
            if (level_db(c) < db) continue;
            const ImVec2 at{to_pixel(plot.x, c.frequency_hz), to_pixel(plot.y, db)};
            draw_receptor_mark(list, theme, at, theme.mark_px * 1.35F, receptor, theme.pane);
            draw_receptor_mark(list, theme, at, theme.mark_px, receptor);
        }
    }
}

// Names at the right ends of the curves, with the type's mark; for types that feel nothing the mark
// is faint, and the name dim but readable.
void draw_names(ImDrawList& list, const Theme& theme, const Plot& plot, const SpectrumScene& scene,
                const PerReceptor<bool>& hears) {
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    std::vector<float> wanted;
    for (const Curve& threshold : *scene.thresholds) {
        wanted.push_back(to_pixel(plot.y, threshold_db(threshold, kHighestComponentHz)) -
                         text_px / 2.0F);
    }
    const auto tops = spread(wanted, text_px, plot.area.min.y, plot.area.max.y);
    const float x = plot.area.max.x + 1.5F * theme.gap_px;
    for (const Receptor receptor : kReceptors) {
        const std::size_t i = index_of(receptor);
        const ImU32 colour =
            hears[i] ? theme.receptor[i] : mixed(theme.receptor[i], theme.pane, 0.45F);
        const ImVec2 corner{x + 2.5F * theme.mark_px, tops[i]};
        draw_receptor_mark(list, theme, {x, tops[i] + text_px * 0.55F}, theme.mark_px * 0.9F,
                           receptor, colour);
        draw_text(list, theme.fonts.small, corner, hears[i] ? colour : theme.dim_text,
                  traits(receptor).name);
    }
}

float names_width(const Theme& theme) {
    float widest = 0.0F;
    for (const Receptor receptor : kReceptors) {
        widest = std::max(widest, text_size(theme.fonts.small, traits(receptor).name).x);
    }
    return widest + 1.5F * theme.gap_px + 2.5F * theme.mark_px;
}

// The component nearest to the mouse, preferring the louder of those within a few pixels.
std::optional<std::size_t> nearest(const Theme& theme, const Plot& plot,
                                   std::span<const Component> components, float x_px) {
    std::optional<std::size_t> best;
    const float reach = 6.0F * theme.scale;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (level_db(components[i]) < plot.y.low) continue;
        const float away = std::abs(to_pixel(plot.x, components[i].frequency_hz) - x_px);
        if (away > reach) continue;
        if (!best || components[i].skin_um > components[*best].skin_um) best = i;
    }
    return best;
}

}  // namespace

double level_db(const Component& component) {
    return 20.0 * std::log10(displacement_um(component.amplitude_g, component.frequency_hz));
}

PerReceptor<bool> reached(std::span<const Component> components,
                          const PerReceptor<Curve>& thresholds) {
    PerReceptor<bool> result{};
    for (std::size_t i = 0; i < kReceptorCount; ++i) {
        result[i] = std::any_of(components.begin(), components.end(), [&](const Component& c) {
            return level_db(c) >= threshold_db(thresholds[i], c.frequency_hz);
        });
    }
    return result;
}

std::vector<float> spread(std::span<const float> wanted, float height, float low, float high) {
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    std::vector<float> tops(wanted.begin(), wanted.end());
    float free_from = low;
    for (const std::size_t i : order) {
        tops[i] = std::max(tops[i], free_from);
        free_from = tops[i] + height;
    }
    // Pushed below the end: push back up from there.
    float free_to = high;
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        tops[*i] = std::min(tops[*i], free_to - height);
        free_to = tops[*i];
    }
    return tops;
}

SpectrumAction draw_spectrum(const char* id, const Theme& theme, const Rect& area,
                             const SpectrumScene& scene) {
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    assert(scene.thresholds != nullptr && "a spectrum is drawn against thresholds");
    const Axis frequency{
        .low = kLowestComponentHz, .high = kHighestComponentHz, .scale = Scale::logarithmic};
    Rect outer = area;
    const bool named = area.width() > 3.0F * names_width(theme);
    if (named) outer.max.x -= names_width(theme);
    const Plot plot = plot_within(outer, theme, frequency, level_axis(scene), kLabels);
    if (plot.area.empty()) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, area.size());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    SpectrumAction action;
    if (ImGui::IsItemHovered() && plot.area.contains(mouse)) {
        action.hovered = nearest(theme, plot, scene.components, mouse.x);
    }

    take_curve(id, theme, plot, scene, action);
    const PerReceptor<bool> hears = reached(scene.components, *scene.thresholds);
    draw_axes(list, theme, plot, kLabels);
    draw_tick_of_peak(list, theme, plot);
    list.PushClipRect(plot.area.min, plot.area.max, true);
    for (std::size_t i = 0; i < scene.components.size(); ++i) {
        draw_bar(list, theme, plot, scene, scene.components[i], action.hovered == i);
    }
    draw_ghosts(list, theme, plot, scene);
    for (std::size_t i = 0; i < kReceptorCount; ++i) {
        const ImU32 colour = faded(theme.receptor[i], hears[i] ? 1.0F : 0.45F);
        draw_threshold(list, theme, plot, kReceptors[i], (*scene.thresholds)[i], colour);
    }
    draw_measured(list, theme, plot, scene);
    draw_crossings(list, theme, plot, scene);
    list.PopClipRect();
    if (named) draw_names(list, theme, plot, scene, hears);
    if (scene.stale) draw_stale(list, theme, plot.area, ImGui::GetTime());
    if (action.hovered) {
        const Component& c = scene.components[*action.hovered];
        const std::array<std::string, 3> lines{
            significant(c.frequency_hz) + " Hz",
            significant(displacement_um(c.amplitude_g, c.frequency_hz)) + " µm peak",
            significant(c.amplitude_g) + " g peak"};
        draw_readout(list, theme, area, mouse, lines);
    }
    return action;
}

}  // namespace tact
