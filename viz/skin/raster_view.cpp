#include "viz/skin/raster_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/skin/raster_cells.h"

namespace tact {
namespace {

std::size_t row_of(const RasterChannel& channel, std::size_t receptor) {
    if (channel.order.empty()) return receptor;
    const auto found = std::ranges::find(channel.order, receptor);
    return static_cast<std::size_t>(found - channel.order.begin());
}

// One receptor's row across the view, with its spikes in the text's colour.
void draw_standing_row(ImDrawList& list, const Theme& theme, const RasterLayout& layout,
                       const RasterScene& scene, const RasterSpot& spot, ImU32 frame) {
    if (spot.channel >= scene.channels.size()) return;
    const RasterChannel& channel = scene.channels[spot.channel];
    const RasterBand& band = layout.bands[spot.channel];
    const std::size_t row = row_of(channel, spot.receptor);
    if (row >= channel.spike_count.size() || !band.fires) return;
    const float height = std::max(std::round(band.row_px), 4.0F * theme.scale);
    const float middle = band.rows.min.y + (static_cast<float>(row) + 0.5F) * band.row_px;
    Rect place =
        rect_at({band.rows.min.x, std::round(middle - height / 2.0F)}, {band.rows.width(), height});
    place = moved_into(place, band.rows);
    list.AddRectFilled(place.min, place.max, mixed(theme.pane, frame, 0.22F));
    RasterWindow window = window_of(layout.plot, channel);
    window.top = row;
    window.bottom = row + 1;
    draw_rows(raster_ink(list, theme, layout.plot, theme.text), place, channel, window, 1);
    draw_level_line(list, place.min.y, place.min.x, place.max.x, theme.hairline_px, frame);
    draw_level_line(list, place.max.y, place.min.x, place.max.x, theme.hairline_px, frame);
}

void draw_channel(ImDrawList& list, const Theme& theme, const RasterLayout& layout,
                  const RasterChannel& channel, const RasterBand& band, const RasterTotals& all) {
    const RasterInk ink =
        raster_ink(list, theme, layout.plot, theme.receptor[index_of(channel.receptor)]);
    draw_level_line(list, band.fires ? band.rate.max.y : band.rows.centre().y, band.rows.min.x,
                    band.rows.max.x, theme.hairline_px, mixed(theme.pane, theme.line, 0.8F));
    if (!band.fires) return;
    RasterWindow window = window_of(layout.plot, channel);
    window.bottom = channel.spike_count.size();
    draw_rows(ink, band.rows, channel, window, std::max(1, all.largest_count));
    draw_rate(ink, band.rate, window, all);
}

// Three digits: 315 800 is 316k.
std::string short_number(double value) {
    return value >= 1000.0 ? significant(value / 1000.0) + "k" : significant(value);
}

// Left of the time axis: the type, its number of rows, and the top of the rate's trace.
void draw_names(ImDrawList& list, const Theme& theme, const Rect& area, const RasterLayout& layout,
                const RasterScene& scene, std::span<const RasterTotals> all) {
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const float mark_px = 2.6F * theme.mark_px;
    const float room = layout.plot.area.min.x - area.min.x - theme.gap_px;
    if (room < mark_px + text_px) return;
    for (std::size_t i = 0; i < layout.bands.size(); ++i) {
        const RasterBand& band = layout.bands[i];
        const Receptor receptor = scene.channels[i].receptor;
        const ImU32 hue = theme.receptor[index_of(receptor)];
        const float bottom = band.rate.empty() ? band.rows.max.y : band.rate.max.y;
        if (bottom - band.rows.min.y < 0.9F * text_px) continue;
        float top = band.rows.min.y - 0.1F * text_px;
        if (!band.fires) top = band.rows.centre().y - 0.55F * text_px;
        draw_receptor_mark(list, theme, {area.min.x + theme.mark_px, top + 0.55F * text_px},
                           0.85F * theme.mark_px, receptor, hue);
        draw_text(list, font, {area.min.x + mark_px, top}, hue,
                  shortened(font, traits(receptor).name, room - mark_px));
        const std::string& note = scene.channels[i].note;
        const bool is_noted = band.fires && !note.empty() && bottom - top >= 2.3F * text_px;
        if (is_noted) {
            draw_text(list, font, {area.min.x + mark_px, top + 1.1F * text_px}, theme.text,
                      shortened(font, note, room - mark_px));
            top += 1.1F * text_px;
        }
        if (!band.fires || band.rate.empty() || bottom - top < 2.3F * text_px) continue;
        std::string peak = "peak " + short_number(all[i].largest_total / kStepS) + " imp/s";
        if (text_size(font, peak).x > room - mark_px) peak = peak.substr(5);
        draw_text(list, font, {area.min.x + mark_px, bottom - 1.05F * text_px}, theme.dim_text,
                  shortened(font, peak, room - mark_px));
    }
}

void draw_silent_words(ImDrawList& list, const Theme& theme, const RasterLayout& layout) {
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    for (const RasterBand& band : layout.bands) {
        if (band.fires || band.rows.height() < 0.9F * text_px) continue;
        const std::string words = shortened(font, "no spikes", band.rows.width());
        const ImVec2 size = text_size(font, words);
        const ImVec2 corner{band.rows.centre().x - size.x / 2.0F,
                            band.rows.centre().y - 0.55F * text_px};
        list.AddRectFilled(corner - ImVec2{theme.gap_px, 0.0F},
                           corner + size + ImVec2{theme.gap_px, 0.0F}, theme.pane);
        draw_text(list, font, corner, theme.dim_text, words);
    }
}

// Weight of a channel's height: more for more rows, and some for its name.
float weight_of(std::size_t rows) {
    return rows > 0 ? 3.0F + std::sqrt(static_cast<float>(rows)) : 0.0F;
}

// Shares the height by weight among channels with these numbers of rows; a row gets at most
// `most_px`, and a channel at least `least_px`, the height of its name, if there is enough.
std::vector<float> shared_out(std::span<const std::size_t> rows, float height, float most_px,
                              float least_px) {
    const auto firing = static_cast<float>(rows.size() - std::ranges::count(rows, 0U));
    least_px = std::min(least_px, std::max(0.0F, height) / std::max(1.0F, firing));
    std::vector<float> result(rows.size(), 0.0F);
    std::vector<bool> capped(rows.size(), false);
    for (std::size_t round = 0; round <= rows.size(); ++round) {
        float free = height;
        float weight = 0.0F;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i] > 0) free -= capped[i] ? result[i] : least_px;
            if (!capped[i]) weight += weight_of(rows[i]);
        }
        bool changed = false;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (capped[i] || rows[i] == 0) continue;
            result[i] = least_px + std::max(0.0F, free) * weight_of(rows[i]) / weight;
            const float most = std::max(least_px, most_px * static_cast<float>(rows[i]));
            if (result[i] <= most) continue;
            result[i] = most;
            capped[i] = changed = true;
        }
        if (!changed) break;
    }
    return result;
}

float names_width(const Theme& theme, const Rect& area, const RasterScene& scene) {
    if (scene.names_px) return std::min(*scene.names_px, 0.6F * area.width());
    float widest = text_size(theme.fonts.small, "peak 0.00k imp/s").x;
    for (const RasterChannel& channel : scene.channels) {
        widest = std::max({widest, text_size(theme.fonts.small, traits(channel.receptor).name).x,
                           text_size(theme.fonts.small, channel.note).x});
    }
    return std::min(widest + 2.6F * theme.mark_px + theme.gap_px, 0.25F * area.width());
}

RasterAction read_mouse(const char* id, const Rect& area, const RasterLayout& layout,
                        const RasterScene& scene) {
    ImGui::SetCursorScreenPos(area.min);
    const bool clicked = ImGui::InvisibleButton(id, area.size());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double time_s = std::clamp(to_value(layout.plot.x, mouse.x), scene.start_s, scene.end_s);
    RasterAction action;
    if (ImGui::IsItemActive()) action.scrubbed_s = time_s;
    if (!ImGui::IsItemHovered() || !layout.plot.area.contains(mouse)) return action;
    action.hovered_s = time_s;
    action.hovered = spot_at(layout, scene, mouse);
    const ImVec2 pressed = ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Left];
    if (clicked && spot_at(layout, scene, pressed) == action.hovered) {
        action.clicked = action.hovered;
    }
    return action;
}

}  // namespace

RasterLayout raster_layout(const Theme& theme, const Rect& area, const RasterScene& scene) {
    Rect outer = area;
    outer.min.x += names_width(theme, area, scene);
    const Axis time{.low = scene.start_s, .high = scene.end_s};
    const PlotLabels labels{.x_unit = scene.time_axis ? "s" : "", .y_unit = "", .y_grid = false};
    RasterLayout layout{plot_within(outer, theme, time, {}, labels), {}};
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float gap = 0.75F * theme.gap_px;
    float free = layout.plot.area.height() + gap;
    // Types that never fire leave their share of a low area to the others.
    const float silent_px = std::min(
        text_px, 0.4F * free / static_cast<float>(std::max<std::size_t>(1, scene.channels.size())));
    std::vector<std::size_t> rows;
    for (const RasterChannel& channel : scene.channels) {
        layout.bands.push_back({.fires = any_spike(channel)});
        rows.push_back(layout.bands.back().fires ? channel.spike_count.size() : 0);
        free -= gap + (layout.bands.back().fires ? 0.0F : silent_px);
    }
    const auto firing = static_cast<float>(rows.size() - std::ranges::count(rows, 0U));
    float rate_px = scene.rates ? 18.0F * theme.scale : 0.0F;
    if (firing * (rate_px + 24.0F * theme.scale) > free) rate_px = 0.0F;
    const auto heights = shared_out(rows, free - firing * rate_px, 14.0F * theme.scale, text_px);
    float top = layout.plot.area.min.y;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        RasterBand& band = layout.bands[i];
        const float height = band.fires ? std::floor(heights[i]) : silent_px;
        band.rows = {{layout.plot.area.min.x, top}, {layout.plot.area.max.x, top + height}};
        band.rate = {{band.rows.min.x, band.rows.max.y},
                     {band.rows.max.x, band.rows.max.y + (band.fires ? rate_px : 0.0F)}};
        if (rows[i] > 0) band.row_px = height / static_cast<float>(rows[i]);
        top = std::round(band.rate.max.y + gap);
    }
    return layout;
}

std::optional<RasterSpot> spot_at(const RasterLayout& layout, const RasterScene& scene, ImVec2 at) {
    for (std::size_t i = 0; i < layout.bands.size(); ++i) {
        const RasterBand& band = layout.bands[i];
        if (!band.fires || !band.rows.contains(at) || band.row_px <= 0.0F) continue;
        const RasterChannel& channel = scene.channels[i];
        const auto row = std::min(static_cast<std::size_t>((at.y - band.rows.min.y) / band.row_px),
                                  channel.spike_count.size() - 1);
        return RasterSpot{i, channel.order.empty() ? row : channel.order[row]};
    }
    return std::nullopt;
}

RasterAction draw_raster(const char* id, const Theme& theme, const Rect& area,
                         const RasterScene& scene) {
    assert(scene.start_s < scene.end_s && "a raster shows a stretch of time");
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (scene.channels.empty()) {
        draw_empty(list, theme, area, "Spikes of all receptors", "not computed yet");
        return {};
    }
    const RasterLayout layout = raster_layout(theme, area, scene);
    if (layout.plot.area.empty()) return {};
    const RasterAction action = read_mouse(id, area, layout, scene);

    list.PushClipRect(area.min, area.max, true);
    draw_axes(list, theme, layout.plot,
              {.x_unit = scene.time_axis ? "s" : "", .y_unit = "", .y_grid = false});
    list.PushClipRect(layout.plot.area.min, layout.plot.area.max, true);
    std::vector<RasterTotals> all;
    for (std::size_t i = 0; i < scene.channels.size(); ++i) {
        all.push_back(totals(scene.channels[i]));
        draw_channel(list, theme, layout, scene.channels[i], layout.bands[i], all.back());
        const RasterBand& band = layout.bands[i];
        if (scene.channels[i].pale && band.fires) {
            list.AddRectFilled(band.rows.min, {band.rows.max.x, band.rate.max.y},
                               faded(theme.pane, 0.65F));
        }
    }
    const std::optional<RasterSpot> pointed = action.hovered ? action.hovered : scene.pointed;
    if (pointed && pointed != scene.selected) {
        draw_standing_row(list, theme, layout, scene, *pointed, theme.dim_text);
    }
    if (scene.selected) {
        draw_standing_row(list, theme, layout, scene, *scene.selected, theme.accent);
    }
    draw_silent_words(list, theme, layout);
    if (scene.stale) draw_stale(list, theme, layout.plot.area, ImGui::GetTime());
    const ImU32 dim = faded(theme.dim_text, 0.6F);
    if (scene.crosshair_s) draw_cursor_line(list, theme, layout.plot, *scene.crosshair_s, dim);
    if (scene.playhead_s) {
        draw_cursor_line(list, theme, layout.plot, *scene.playhead_s, theme.accent);
    }
    if (action.hovered_s) draw_cursor_line(list, theme, layout.plot, *action.hovered_s, dim);
    list.PopClipRect();
    if (scene.names_px != 0.0F) draw_names(list, theme, area, layout, scene, all);
    list.PopClipRect();
    return action;
}

}  // namespace tact
