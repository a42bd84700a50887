#include "viz/skin/network_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/skin/network_caption.h"

namespace tact {
namespace {

constexpr float kDotCellPx = 5.0F;    // cells of this size have a dot at the cap, smaller ones an
                                      // outline
constexpr float kSeamCellPx = 10.0F;  // cells of this size can be told apart

// Between cells: darker than any of them, so that the outlines are visible in either theme.
ImU32 seam_colour() { return mixed(viridis(0.0), IM_COL32_BLACK, 0.55F); }

ImU32 over_colours(float opacity) { return faded(IM_COL32_WHITE, opacity); }

// Edges on whole pixels, so that there are no seams between cells.
float edge(float from, float cell_px, int cells) {
    return std::round(from + static_cast<float>(cells) * cell_px);
}

Rect cell_rect(const NetworkLayout& layout, const NetworkScene& scene, const NetworkCell& cell) {
    const Rect& map = layout.maps[cell.layer];
    const int half = scene.layers[cell.layer].half_width;
    const int column = cell.column + half;
    const int row = cell.row + half;
    return {
        {edge(map.min.x, layout.cell_px, column), edge(map.min.y, layout.cell_px, row)},
        {edge(map.min.x, layout.cell_px, column + 1), edge(map.min.y, layout.cell_px, row + 1)}};
}

void add_rect(ImDrawList& list, const Rect& r, ImU32 colour) {
    list.PrimReserve(6, 4);
    list.PrimRect(r.min, r.max, colour);
}

void draw_cells(ImDrawList& list, const Theme& theme, const NetworkLayout& layout,
                const NetworkScene& scene, std::size_t k) {
    const RelayLayer& layer = scene.layers[k];
    const bool told_apart = layout.cell_px >= kSeamCellPx * theme.scale;
    const float seam = told_apart ? theme.hairline_px : 0.0F;
    const auto colour_at = [&](int column, int row) {
        return activity_colour(layer.at(column, row), scene.cap);
    };
    // Cells without activity are one rectangle: a silent network looks the same at any cell size.
    if (told_apart) add_rect(list, layout.maps[k], seam_colour());
    for (int row = -layer.half_width; row <= layer.half_width; ++row) {
        for (int column = -layer.half_width; column <= layer.half_width;) {
            const ImU32 colour = colour_at(column, row);
            int end = column + 1;
            while (!told_apart && end <= layer.half_width && colour_at(end, row) == colour) ++end;
            const Rect first = cell_rect(layout, scene, {k, column, row});
            const Rect last = cell_rect(layout, scene, {k, end - 1, row});
            const float apart = layer.at(column, row) > 0.0 ? seam : 0.0F;
            add_rect(list, {first.min, last.max - ImVec2{apart, apart}}, colour);
            column = end;
        }
    }
}

// The border of the cells for which `inside` holds, `width_px` wide, within those cells.
template <class Inside>
void draw_border(ImDrawList& list, const NetworkLayout& layout, const NetworkScene& scene,
                 std::size_t k, Inside inside, float width_px, ImU32 colour) {
    const int half = scene.layers[k].half_width;
    for (int row = -half; row <= half; ++row) {
        for (int column = -half; column <= half; ++column) {
            if (!inside(column, row)) continue;
            const Rect r = cell_rect(layout, scene, {k, column, row});
            if (!inside(column, row - 1)) {
                add_rect(list, {r.min, {r.max.x, r.min.y + width_px}}, colour);
            }
            if (!inside(column, row + 1)) {
                add_rect(list, {{r.min.x, r.max.y - width_px}, r.max}, colour);
            }
            if (!inside(column - 1, row)) {
                add_rect(list, {r.min, {r.min.x + width_px, r.max.y}}, colour);
            }
            if (!inside(column + 1, row)) {
                add_rect(list, {{r.max.x - width_px, r.min.y}, r.max}, colour);
            }
        }
    }
}

// A saturated cell has lost activity above the cap, so it is marked.
void draw_cap_marks(ImDrawList& list, const Theme& theme, const NetworkLayout& layout,
                    const NetworkScene& scene, std::size_t k) {
    const RelayLayer& layer = scene.layers[k];
    const ImU32 ink = faded(readable_on(viridis(1.0)), 0.75F);
    const auto capped = [&](int column, int row) {
        return scene.cap > 0.0 && layer.at(column, row) >= scene.cap;
    };
    if (layout.cell_px < kDotCellPx * theme.scale) {
        draw_border(list, layout, scene, k, capped, theme.hairline_px, ink);
        return;
    }
    const float radius = std::max(0.9F * theme.scale, 0.11F * layout.cell_px);
    for (int row = -layer.half_width; row <= layer.half_width; ++row) {
        for (int column = -layer.half_width; column <= layer.half_width; ++column) {
            if (!capped(column, row)) continue;
            draw_disc(list, theme, cell_rect(layout, scene, {k, column, row}).centre(), radius,
                      ink);
        }
    }
}

// White on a dark edge reads on every colour of the map.
void draw_cone(ImDrawList& list, const Theme& theme, const NetworkLayout& layout,
               const NetworkScene& scene, std::size_t k) {
    if (k + 1 >= scene.layers.size()) return;  // only the centre: its ring is enough
    const int half = scene.layers[k].half_width;
    const auto inside = [&](int column, int row) {
        return std::max(std::abs(column), std::abs(row)) <= half &&
               reaches_centre(scene, {k, column, row});
    };
    draw_border(list, layout, scene, k, inside, 2.0F * theme.hairline_px,
                faded(IM_COL32_BLACK, 0.55F));
    draw_border(list, layout, scene, k, inside, theme.hairline_px, over_colours(0.95F));
}

void draw_centre_ring(ImDrawList& list, const Theme& theme, const NetworkLayout& layout,
                      const NetworkScene& scene, std::size_t k) {
    const Rect cell = cell_rect(layout, scene, {k, 0, 0});
    // Around the cell if it has neighbours on all sides: beyond its map are words.
    const float inside = 0.5F * (layout.maps[k].width() - 1.5F * theme.scale);
    const float radius = std::max(std::min(0.72F * layout.cell_px, inside), 3.0F * theme.scale);
    list.AddCircle(cell.centre(), radius, faded(IM_COL32_BLACK, 0.6F), 0, 3.0F * theme.scale);
    list.AddCircle(cell.centre(), radius, over_colours(1.0F), 0, 1.5F * theme.scale);
}

// From one map, past its caption, to the next in its row: the direction of activity.
void draw_arrow(ImDrawList& list, const Theme& theme, const NetworkLayout& layout, std::size_t to) {
    const Rect& before = layout.maps[to - 1];
    const Rect& after = layout.maps[to];
    const float y = after.centre().y;
    // Beside words, arrows share their columns with those of other networks, whatever the maps'
    // sizes.
    const float from_px = layout.beside ? layout.captions[to - 1].max.x : before.max.x;
    const float room = layout.beside ? layout.between_px : after.min.x - from_px;
    const float head = std::clamp(0.1F * room, 3.0F * theme.scale, 7.0F * theme.scale);
    if (room < 3.0F * head || std::abs(before.centre().y - y) > 1.0F) return;
    const float length = std::min(0.6F * room, 40.0F * theme.scale);
    const ImVec2 tip{from_px + 0.5F * (room + length), y};
    draw_level_line(list, y, tip.x - length, tip.x - head, 1.5F * theme.scale, theme.dim_text);
    list.AddTriangleFilled({tip.x - 1.4F * head, y - head}, tip, {tip.x - 1.4F * head, y + head},
                           theme.dim_text);
}

void draw_cell_frame(ImDrawList& list, const Theme& theme, const NetworkLayout& layout,
                     const NetworkScene& scene, const NetworkCell& cell) {
    if (cell.layer >= scene.layers.size()) return;
    const Rect r = cell_rect(layout, scene, cell);
    const float out = theme.scale;
    list.AddRect(r.min - ImVec2{out, out}, r.max + ImVec2{out, out}, theme.pane, 0.0F, 0,
                 4.0F * theme.scale);
    list.AddRect(r.min - ImVec2{out, out}, r.max + ImVec2{out, out}, theme.text, 0.0F, 0,
                 2.0F * theme.scale);
}

NetworkAction read_mouse(const char* id, const Rect& area, const NetworkLayout& layout,
                         const NetworkScene& scene) {
    ImGui::SetCursorScreenPos(area.min);
    const bool clicked = ImGui::InvisibleButton(id, area.size());
    NetworkAction action;
    if (!ImGui::IsItemHovered()) return action;
    action.hovered = cell_at(layout, scene, ImGui::GetIO().MousePos);
    if (clicked) action.clicked = action.hovered;
    return action;
}

int largest_half_width(const NetworkScene& scene) {
    int largest = 0;
    for (const RelayLayer& layer : scene.layers) largest = std::max(largest, layer.half_width);
    return largest;
}

// A grid of places for maps, and the cell size that fits there.
struct Slots {
    std::size_t columns = 1;
    ImVec2 size{0, 0};        // size of one place, with its caption
    float between_px = 0.0F;  // gap between neighbours
    ImVec2 caption{0, 0};     // 0 if words do not fit
    bool beside = false;      // the caption is beside the map
    float room_px = 0.0F;     // side of the square for a map, whatever its cells
    float cell_px = 0.0F;
};

// Rounded to whole pixels, unless cells are small.
float cell_size(const Theme& theme, float room_px, int cells) {
    const float cell_px = std::min(room_px / static_cast<float>(cells), 32.0F * theme.scale);
    return cell_px >= 4.0F ? std::floor(cell_px) : std::max(0.0F, cell_px);
}

Slots slots_for(const Theme& theme, const Rect& area, std::size_t count, std::size_t rows,
                int cells) {
    const float gap = 1.5F * theme.gap_px;
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Slots slots;
    slots.columns = (count + rows - 1) / rows;
    const auto in_row = static_cast<float>(slots.columns);
    const auto in_column = static_cast<float>(rows);
    slots.between_px = gap;
    slots.size = {(area.width() - (in_row - 1.0F) * gap) / in_row,
                  (area.height() - (in_column - 1.0F) * 0.5F * gap) / in_column};
    const bool words = slots.size.x >= 4.0F * text_px && slots.size.y >= 5.0F * text_px;
    if (words) slots.caption = {slots.size.x, 2.6F * text_px};
    slots.room_px = std::min(slots.size.x, slots.size.y - slots.caption.y);
    slots.cell_px = cell_size(theme, slots.room_px, cells);
    return slots;
}

// In a low and wide area, maps are as high as the area, with words beside them; arrows get some of
// the rest. Columns depend on the area alone, so that networks below each other share them.
Slots slots_beside(const Theme& theme, const Rect& area, const NetworkScene& scene, int cells) {
    const float gap = 0.75F * theme.gap_px;
    const float least_between = 3.0F * theme.gap_px;
    const float most_between = std::max(96.0F * theme.scale, 0.08F * area.width());
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Slots slots;
    slots.beside = true;
    slots.columns = scene.layers.size();
    slots.caption = {caption_width_px(theme, scene), 2.6F * text_px};
    if (slots.caption.y > area.height() || slots.columns < 2) return slots;
    const auto count = static_cast<float>(slots.columns);
    const float words_px = gap + slots.caption.x;
    const float each = (area.width() - (count - 1.0F) * least_between) / count - words_px;
    slots.room_px = std::max(0.0F, std::min(each, area.height()));
    slots.cell_px = cell_size(theme, slots.room_px, cells);
    slots.size = {slots.room_px + words_px, area.height()};
    slots.between_px =
        std::min((area.width() - count * slots.size.x) / (count - 1.0F), most_between);
    return slots;
}

// Prefers larger maps, unless words would not fit.
bool is_better(const Slots& a, const Slots& b) {
    const auto worth = [](const Slots& slots) {
        return slots.room_px * (slots.caption.x > 0.0F ? 1.25F : 1.0F);
    };
    return worth(a) > worth(b);
}

Slots best_slots(const Theme& theme, const Rect& area, const NetworkScene& scene, int cells) {
    const std::size_t count = scene.layers.size();
    Slots best;
    for (std::size_t rows = 1; rows <= count; ++rows) {
        const Slots slots = slots_for(theme, area, count, rows, cells);
        if (is_better(slots, best)) best = slots;
    }
    const Slots beside = slots_beside(theme, area, scene, cells);
    return is_better(best, beside) ? best : beside;
}

}  // namespace

bool reaches_centre(const NetworkScene& scene, const NetworkCell& cell) {
    const auto layers_left = static_cast<int>(scene.layers.size() - 1 - cell.layer);
    return std::abs(cell.column) + std::abs(cell.row) <= layers_left;
}

bool is_silent(const NetworkScene& scene) {
    return scene.layers.empty() ||
           std::ranges::all_of(scene.layers.front().cells, [](double n) { return n <= 0.0; });
}

NetworkLayout network_layout(const Theme& theme, const Rect& area, const NetworkScene& scene) {
    NetworkLayout layout;
    const std::size_t count = scene.layers.size();
    if (count == 0) return layout;
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Rect maps = area;
    if (scene.legend && area.height() >= 100.0F * theme.scale) {
        layout.legend = {{area.min.x, area.max.y - 1.25F * text_px}, area.max};
        maps.max.y = layout.legend.min.y - 0.4F * text_px;
    }
    const int cells = 2 * largest_half_width(scene) + 1;
    const Slots best = best_slots(theme, maps, scene, cells);
    if (best.cell_px <= 0.0F) return {};
    layout.cell_px = best.cell_px;
    layout.beside = best.beside;
    layout.between_px = best.between_px;
    const float side = best.cell_px * static_cast<float>(cells);
    const float middle = best.beside ? best.size.y / 2.0F : side / 2.0F;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t whole_rows = k / best.columns;
        const auto column = static_cast<float>(k % best.columns);
        const auto row = static_cast<float>(whole_rows);
        const ImVec2 corner = maps.min + ImVec2{column * (best.size.x + best.between_px),
                                                row * (best.size.y + 0.75F * theme.gap_px)};
        const float own = best.cell_px * static_cast<float>(2 * scene.layers[k].half_width + 1);
        // Words stand next to their map, whatever its size.
        const float left = best.beside ? best.room_px - own : 0.5F * (best.size.x - own);
        const ImVec2 first{std::round(corner.x + left), std::round(corner.y + middle - own / 2.0F)};
        layout.maps.push_back(rect_at(first, {own, own}));
        const ImVec2 words = best.beside ? ImVec2{corner.x + best.size.x - best.caption.x,
                                                  corner.y + middle - best.caption.y / 2.0F}
                                         : ImVec2{corner.x, corner.y + side};
        layout.captions.push_back(rect_at(words, best.caption));
    }
    return layout;
}

std::optional<NetworkCell> cell_at(const NetworkLayout& layout, const NetworkScene& scene,
                                   ImVec2 at) {
    for (std::size_t k = 0; k < layout.maps.size(); ++k) {
        const Rect& map = layout.maps[k];
        if (!map.contains(at) || layout.cell_px <= 0.0F) continue;
        const int half = scene.layers[k].half_width;
        const auto place = [&](float offset_px) {
            return std::clamp(static_cast<int>(offset_px / layout.cell_px) - half, -half, half);
        };
        return NetworkCell{k, place(at.x - map.min.x), place(at.y - map.min.y)};
    }
    return std::nullopt;
}

NetworkAction draw_network(const char* id, const Theme& theme, const Rect& area,
                           const NetworkScene& scene) {
    assert(scene.names.size() == scene.layers.size() && "one name for each layer");
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (scene.layers.empty()) {
        draw_empty(list, theme, area, "Relay network", "not computed yet");
        return {};
    }
    const NetworkLayout layout = network_layout(theme, area, scene);
    if (layout.cell_px <= 0.0F) return {};
    const NetworkAction action = read_mouse(id, area, layout, scene);

    list.PushClipRect(area.min, area.max, true);
    for (std::size_t k = 0; k < scene.layers.size(); ++k) {
        draw_cells(list, theme, layout, scene, k);
        draw_cap_marks(list, theme, layout, scene, k);
        draw_cone(list, theme, layout, scene, k);
        draw_centre_ring(list, theme, layout, scene, k);
        if (scene.stale) draw_stale(list, theme, layout.maps[k], ImGui::GetTime());
        draw_layer_caption(list, theme, layout.captions[k], layout.beside, scene, k);
        if (k > 0) draw_arrow(list, theme, layout, k);
    }
    if (is_silent(scene) && !layout.legend.empty()) {
        const ImFont* font = theme.fonts.small;
        draw_text(list, font, layout.legend.min, theme.dim_text,
                  shortened(font, "no spikes in this step", layout.legend.width()));
    } else {
        draw_network_legend(list, theme, layout.legend, scene.cap);
    }
    const std::optional<NetworkCell> pointed = action.hovered ? action.hovered : scene.pointed;
    if (pointed) draw_cell_frame(list, theme, layout, scene, *pointed);
    list.PopClipRect();
    return action;
}

}  // namespace tact
