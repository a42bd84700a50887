#include "viz/charts/matrix_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/text/numbers.h"
#include "viz/charts/matrix_parts.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {
namespace {

double value_of(const MatrixScene& scene, std::size_t i, std::size_t j) {
    if (i == j) return std::numeric_limits<double>::quiet_NaN();
    const auto object = [&scene](std::size_t row) {
        return scene.order.empty() ? row : scene.order[row];
    };
    const auto [a, b] = std::minmax({object(i), object(j)});
    return scene.condensed[pair_index(scene.labels.size(), a, b)];
}

// Objects [first, last) in one drawn row.
std::pair<std::size_t, std::size_t> block(std::size_t row, std::size_t shown, std::size_t n) {
    return {row * n / shown, (row + 1) * n / shown};
}

// Mean of at most 3 x 3 known pairs of a block, evenly spread; NaN if none is known.
double block_mean(const MatrixScene& scene, std::pair<std::size_t, std::size_t> rows,
                  std::pair<std::size_t, std::size_t> columns) {
    const auto step = [](const std::pair<std::size_t, std::size_t>& b) {
        return std::max<std::size_t>(1, (b.second - b.first + 2) / 3);
    };
    double sum = 0.0;
    int known = 0;
    for (std::size_t i = rows.first; i < rows.second; i += step(rows)) {
        for (std::size_t j = columns.first; j < columns.second; j += step(columns)) {
            const double value = value_of(scene, i, j);
            if (std::isnan(value)) continue;
            sum += value;
            ++known;
        }
    }
    return known > 0 ? sum / known : std::numeric_limits<double>::quiet_NaN();
}

// The colour of a value; one quiet tone if all are equal.
struct Shades {
    const Theme& theme;
    double largest = 1.0;
    bool flat = false;

    ImU32 operator()(double value) const {
        if (std::isnan(value)) return theme.field;
        return flat ? theme.hover : closeness_colour(value / largest);
    }
};

// Cells as flat quads; edges on whole pixels, so that there are no seams between them.
void draw_cells(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                const MatrixScene& scene, const Shades& shades) {
    const std::size_t n = scene.labels.size();
    const ImVec2 side = layout.cells.size() * (1.0F / static_cast<float>(layout.shown));
    const auto x = [&](std::size_t k) {
        return std::round(layout.cells.min.x + static_cast<float>(k) * side.x);
    };
    const auto y = [&](std::size_t k) {
        return std::round(layout.cells.min.y + static_cast<float>(k) * side.y);
    };
    const float seam = std::min(side.x, side.y) >= 8.0F * theme.scale ? theme.hairline_px : 0.0F;
    const auto cell = [&](std::size_t row, std::size_t column, ImU32 colour) {
        list.PrimReserve(6, 4);
        list.PrimRect({x(column), y(row)}, {x(column + 1) - seam, y(row + 1) - seam}, colour);
    };
    for (std::size_t row = 0; row < layout.shown; ++row) {
        for (std::size_t column = row; column < layout.shown; ++column) {
            const double mean =
                block_mean(scene, block(row, layout.shown, n), block(column, layout.shown, n));
            const ImU32 colour = shades(mean);
            cell(row, column, colour);
            if (row != column) cell(column, row, colour);
        }
    }
}

bool is_selected(const MatrixScene& scene, std::size_t i) {
    return std::ranges::binary_search(scene.selected, i);
}

// With many patterns only the selected ones have numbers: a hundred are too many to read.
void draw_values(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                 const MatrixScene& scene, const Shades& shades) {
    if (!layout.has_values) return;
    const ImFont* font = theme.fonts.small;
    const std::size_t n = scene.labels.size();
    const bool few = n <= kMostWithAllValues;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double value = value_of(scene, i, j);
            if (std::isnan(value) || !(few || is_selected(scene, i) || is_selected(scene, j)))
                continue;
            const std::string text = cell_text(scene, value, shades.largest);
            const ImVec2 size = text_size(font, text);
            const ImVec2 middle{
                layout.cells.min.x + (static_cast<float>(j) + 0.5F) * layout.cell_px.x,
                layout.cells.min.y + (static_cast<float>(i) + 0.5F) * layout.cell_px.y};
            draw_text(list, font, middle - size * 0.5F, readable_on(shades(value)), text);
        }
    }
}

ImU32 label_colour(const Theme& theme, const MatrixScene& scene, std::optional<Pair> pointed,
                   std::size_t i) {
    if (pointed && (pointed->first == i || pointed->second == i)) return theme.accent;
    return is_selected(scene, i) ? theme.text : theme.dim_text;
}

// Every label_step-th name; the selected and the pointed-at ones always, replacing neighbours.
void draw_names(ImDrawList& list, const Theme& theme, const Rect& area, const MatrixLayout& layout,
                const MatrixScene& scene, std::optional<Pair> pointed) {
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    // The cells begin on a whole pixel, which may take a part of one from the names.
    const float room = layout.cells.min.x - area.min.x - theme.gap_px + 1.0F;
    const auto draw_row = [&](std::size_t i) {
        // Short names need little room; too short a piece of a long one would be illegible.
        const std::string& whole = scene.labels[i];
        if (room < 2.0F * text_px && text_size(font, whole).x > room) return;
        const std::string name = shortened(font, whole, room);
        const ImVec2 size = text_size(font, name);
        const float middle = layout.cells.min.y + (static_cast<float>(i) + 0.5F) * layout.cell_px.y;
        const ImVec2 corner{layout.cells.min.x - theme.gap_px - size.x, middle - text_px * 0.55F};
        draw_text(list, font, corner, label_colour(theme, scene, pointed, i), name);
    };
    std::vector<std::size_t> standing;
    const auto collides = [&](std::size_t i) {
        return std::any_of(standing.begin(), standing.end(), [&](std::size_t other) {
            const std::size_t rows = std::max(i, other) - std::min(i, other);
            return static_cast<float>(rows) * layout.cell_px.y < 1.1F * text_px;
        });
    };
    const auto stand = [&](std::size_t i) {
        if (i < scene.labels.size() && !collides(i)) standing.push_back(i);
    };
    if (pointed) stand(pointed->first);
    if (pointed) stand(pointed->second);
    for (const std::size_t i : scene.selected) stand(i);
    for (std::size_t i = 0; layout.label_step > 0 && i < scene.labels.size();
         i += layout.label_step) {
        if (!collides(i)) draw_row(i);
    }
    for (const std::size_t i : standing) draw_row(i);
    if (!layout.column_labels) return;
    const float height = layout.cells.min.y - area.min.y - theme.gap_px + 1.0F;
    for (std::size_t i = 0; i < scene.labels.size(); ++i) {
        const float level_px = layout.cell_px.x - 0.5F * theme.gap_px;
        const std::string name =
            shortened(font, scene.labels[i], layout.level_labels ? level_px : height);
        const float middle = layout.cells.min.x + (static_cast<float>(i) + 0.5F) * layout.cell_px.x;
        const ImU32 colour = label_colour(theme, scene, pointed, i);
        if (layout.level_labels) {
            const float left = middle - text_size(font, name).x / 2.0F;
            draw_text(list, font, {left, layout.cells.min.y - text_px - theme.gap_px / 2}, colour,
                      name);
        } else {
            draw_text_upwards(list, font,
                              {middle - text_px * 0.5F, layout.cells.min.y - theme.gap_px * 0.75F},
                              colour, name);
        }
    }
}

void draw_scale(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                const MatrixScene& scene, const Shades& shades) {
    const Rect& bar = layout.scale;
    if (bar.empty()) return;
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const std::string top = grouped(shades.largest) + " " + std::string{scene.quantity};
    if (shades.flat) {
        draw_text(list, font, bar.min, theme.dim_text, "all pairs equal");
        return draw_text(list, font, {bar.min.x, bar.min.y + 1.2F * text_px}, theme.dim_text, top);
    }
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i) {
        const float low = static_cast<float>(i) / kSteps;
        const float high = static_cast<float>(i + 1) / kSteps;
        list.AddRectFilled({bar.min.x, std::round(bar.max.y - high * bar.height())},
                           {bar.max.x, std::round(bar.max.y - low * bar.height())},
                           closeness_colour((i + 0.5) / kSteps));
    }
    const float left = bar.max.x + theme.gap_px * 0.75F;
    draw_text(list, font, {left, bar.min.y - text_px * 0.2F}, theme.dim_text, top);
    if (bar.height() < 1.9F * text_px) return;
    draw_text(list, font, {left, bar.max.y - text_px * 0.9F}, theme.dim_text, "0");
    if (bar.height() < 4.2F * text_px) return;
    draw_text(list, font, {left, bar.min.y + text_px * 1.0F}, theme.dim_text, "far apart");
    draw_text(list, font, {left, bar.max.y - text_px * 2.1F}, theme.dim_text, "alike");
}

// "0 alike", the colours, "far apart 61.8 PM": in one line, without words if it is short.
void draw_scale_below(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                      const MatrixScene& scene, const Shades& shades) {
    const Rect& line = layout.scale_below;
    if (line.empty()) return;
    const ImFont* font = theme.fonts.small;
    const std::string most = grouped(shades.largest) + " " + std::string{scene.quantity};
    if (shades.flat) {
        return draw_text(list, font, line.min, theme.dim_text,
                         shortened(font, "all pairs equal, " + most, line.width()));
    }
    const float gap = 0.75F * theme.gap_px;
    const float least = 40.0F * theme.scale;
    const auto bar_between = [&](const std::string& low, const std::string& high) {
        return Rect{{line.min.x + text_size(font, low).x + gap, line.min.y},
                    {line.max.x - text_size(font, high).x - gap, line.max.y}};
    };
    std::string low = "0 alike";
    std::string high = "far apart " + most;
    if (bar_between(low, high).width() < least) {
        low = "0";
        high = most;
    }
    const Rect bar = bar_between(low, high);
    if (bar.width() < 0.5F * least) return;
    draw_text(list, font, line.min, theme.dim_text, low);
    draw_text(list, font, {bar.max.x + gap, line.min.y}, theme.dim_text, high);
    constexpr int kSteps = 64;
    const float inset = std::round(0.25F * line.height());
    for (int i = 0; i < kSteps; ++i) {
        const auto at = [&bar](int step) {
            return std::round(bar.min.x + static_cast<float>(step) / kSteps * bar.width());
        };
        list.AddRectFilled({at(i), bar.min.y + inset}, {at(i + 1), bar.max.y - inset},
                           closeness_colour((i + 0.5) / kSteps));
    }
}

// A thin frame around the rows and the columns of objects [first, last), which are neighbours.
void draw_band(ImDrawList& list, const Theme& theme, const MatrixLayout& layout, std::size_t first,
               std::size_t last, ImU32 colour) {
    const Rect& c = layout.cells;
    const ImVec2 low = layout.cell_px * static_cast<float>(first);
    const ImVec2 extent = layout.cell_px * static_cast<float>(last - first);
    const ImVec2 high = low + ImVec2{std::max(extent.x, 2.0F), std::max(extent.y, 2.0F)};
    list.AddRect({c.min.x, c.min.y + low.y}, {c.max.x, c.min.y + high.y}, colour, 0.0F, 0,
                 theme.hairline_px);
    list.AddRect({c.min.x + low.x, c.min.y}, {c.min.x + high.x, c.max.y}, colour, 0.0F, 0,
                 theme.hairline_px);
}

// Neighbours share one frame, so that the values of many selected objects stay visible.
void draw_selected(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                   const MatrixScene& scene) {
    const auto& all = scene.selected;
    for (std::size_t k = 0; k < all.size() && all[k] < scene.labels.size();) {
        std::size_t end = k + 1;
        while (end < all.size() && all[end] == all[end - 1] + 1) ++end;
        const std::size_t last = std::min(all[end - 1] + 1, scene.labels.size());
        draw_band(list, theme, layout, all[k], last, theme.text);
        k = end;
    }
}

void draw_cell_frame(ImDrawList& list, const Theme& theme, const MatrixLayout& layout,
                     const Pair& pair) {
    for (const auto& [i, j] : {pair, Pair{pair.second, pair.first}}) {
        const ImVec2 corner{layout.cells.min.x + static_cast<float>(j) * layout.cell_px.x,
                            layout.cells.min.y + static_cast<float>(i) * layout.cell_px.y};
        const Rect frame =
            rect_at(corner, {std::max(layout.cell_px.x, 4.0F), std::max(layout.cell_px.y, 4.0F)});
        list.AddRect(frame.min, frame.max, theme.pane, 0, 0, 4.0F * theme.scale);
        list.AddRect(frame.min, frame.max, theme.text, 0, 0, 2.0F * theme.scale);
    }
}

// The pair under the mouse, and whether it was pressed.
MatrixAction read_mouse(const char* id, const Rect& area, const MatrixLayout& layout,
                        std::size_t n) {
    ImGui::SetCursorScreenPos(area.min);
    const bool clicked = ImGui::InvisibleButton(id, area.size());
    if (!ImGui::IsItemHovered()) return {};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto row = row_at(layout, n, mouse.y - layout.cells.min.y);
    const auto column = column_at(layout, n, mouse.x - layout.cells.min.x);
    MatrixAction action;
    if (row && column && *row != *column) {
        action.hovered = Pair{*row, *column};
        if (clicked) action.clicked = action.hovered;
    } else if (row && mouse.x < layout.cells.max.x && clicked) {
        action.clicked_row = row;
    }
    if (row && mouse.x < layout.cells.max.x) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return action;
}

}  // namespace

MatrixAction draw_matrix(const char* id, const Theme& theme, const Rect& area,
                         const MatrixScene& scene) {
    const std::size_t n = scene.labels.size();
    assert(scene.condensed.size() == pair_count(n) && "one value for each pair of names");
    if (area.width() < 1.0F || area.height() < 1.0F || n < 2) return {};
    const MatrixLayout layout = matrix_layout(theme, area, scene);
    if (layout.cells.empty() || layout.shown == 0) return {};
    const MatrixAction action = read_mouse(id, area, layout, n);
    const std::optional<Pair> pointed = action.hovered ? action.hovered : scene.pointed;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Shades shades{theme, largest_of(scene), is_flat(scene)};
    draw_cells(list, theme, layout, scene, shades);
    draw_values(list, theme, layout, scene, shades);
    if (scene.stale) draw_stale(list, theme, layout.cells, ImGui::GetTime());
    draw_scale(list, theme, layout, scene, shades);
    draw_scale_below(list, theme, layout, scene, shades);
    draw_selected(list, theme, layout, scene);
    if (pointed) draw_cell_frame(list, theme, layout, *pointed);
    draw_names(list, theme, area, layout, scene, pointed);
    if (action.hovered) {
        const auto [i, j] = *action.hovered;
        const std::array<std::string, 3> lines{
            std::string{scene.quantity} + " " + value_text(value_of(scene, i, j), shades.largest),
            scene.labels[i] + " – " + scene.labels[j],
            "Its cell has the colour of a mean: up to 3 x 3 pairs around it."};
        const std::size_t told = layout.shown < n ? 3 : 2;
        draw_readout(list, theme, area, ImGui::GetIO().MousePos, std::span(lines).first(told));
    }
    return action;
}

}  // namespace tact
