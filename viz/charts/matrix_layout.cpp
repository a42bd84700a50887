#include <algorithm>
#include <cmath>

#include "model/text/numbers.h"
#include "viz/charts/matrix_parts.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

bool is_rounding(double value, double largest) { return std::abs(value) < 1e-9 * largest; }

float widest_label_px(const Theme& theme, const MatrixScene& scene) {
    float widest = 0.0F;
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.labels.size(), 500); ++i) {
        widest = std::max(widest, text_size(theme.fonts.small, scene.labels[i]).x);
    }
    return widest;
}

float scale_room_px(const Theme& theme, const MatrixScene& scene) {
    const ImFont* font = theme.fonts.small;
    const std::string most = grouped(largest_of(scene)) + " " + std::string{scene.quantity};
    const float numbers =
        std::max(text_size(font, "0000 " + std::string{scene.quantity}).x, text_size(font, most).x);
    const float flat = is_flat(scene) ? text_size(font, "all pairs equal").x : 0.0F;
    return std::max(numbers, flat) + 5.0F * theme.gap_px;
}

// The cell size that fits every number; zero if there are too many cells for numbers.
ImVec2 widest_value_px(const Theme& theme, const MatrixScene& scene) {
    constexpr std::size_t kMostWithValues = 60;
    if (scene.labels.size() > kMostWithValues) return {0.0F, 0.0F};
    const double largest = largest_of(scene);
    float widest = 1.0F;
    for (const double value : scene.condensed) {
        if (std::isnan(value)) continue;
        widest = std::max(widest, text_size(theme.fonts.small, cell_text(scene, value, largest)).x);
    }
    return {widest + 0.5F * theme.gap_px,
            font_or_current(theme.fonts.small).FontSize + theme.scale};
}

// A side of a few pixels or more is a whole number of them; cells of a few objects are limited in
// size, and never narrow strips.
ImVec2 cell_size(const Theme& theme, ImVec2 room, std::size_t n) {
    const bool few = n <= kMostWithAllValues;
    const float wide = few ? 2.8F : 1.0F;  // relative to its height
    const float high = few ? 1.4F : 1.0F;
    const ImVec2 most{96.0F * theme.scale, 64.0F * theme.scale};
    const auto objects = static_cast<float>(std::max<std::size_t>(n, 1));
    const ImVec2 each{std::max(0.0F, room.x / objects), std::max(0.0F, room.y / objects)};
    const auto side = [](float px, float limit, float most_px) {
        const float fits = std::min(px, limit);
        return fits >= 4.0F ? std::min(std::floor(fits), most_px) : fits;
    };
    return {side(each.x, wide * each.y, most.x), side(each.y, high * each.x, most.y)};
}

std::optional<std::size_t> index_at(float cell_px, std::size_t n, float offset_px) {
    if (offset_px < 0.0F || cell_px <= 0.0F) return std::nullopt;
    const auto index = static_cast<std::size_t>(offset_px / cell_px);
    if (index >= n) return std::nullopt;
    return index;
}

}  // namespace

double largest_of(const MatrixScene& scene) {
    if (scene.largest > 0.0) return scene.largest;
    double largest = 0.0;
    for (const double value : scene.condensed) {
        if (value > largest) largest = value;
    }
    return largest > 0.0 ? largest : 1.0;
}

bool is_flat(const MatrixScene& scene) {
    const auto& all = scene.condensed;
    return all.size() > 1 && all[0] > 0.0 &&
           std::all_of(all.begin(), all.end(), [&](double value) { return value == all[0]; });
}

std::string value_text(double value, double largest) {
    return is_rounding(value, largest) ? "0" : grouped(value);
}

std::string cell_text(const MatrixScene& scene, double value, double largest) {
    if (scene.labels.size() <= kMostWithAllValues) return value_text(value, largest);
    return is_rounding(value, largest) ? "0" : significant(value, 2);
}

MatrixLayout matrix_layout(const Theme& theme, const Rect& area, const MatrixScene& scene) {
    const std::size_t n = scene.labels.size();
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float widest = widest_label_px(theme, scene);
    const float left = std::min(widest, area.width() * 0.3F) + theme.gap_px;
    const float right = scale_room_px(theme, scene);
    const float top = std::min(widest, area.height() * 0.25F) + theme.gap_px;
    const ImVec2 value_px = widest_value_px(theme, scene);
    // Upright names leave less height to the cells than level ones, which are shown whole or not at
    // all.
    const float level_top = std::min(top, text_px + theme.gap_px);
    const auto sized = [&](bool with_scale) {
        const float width = area.width() - left - (with_scale ? right : 0.0F);
        MatrixLayout layout;
        layout.cell_px = cell_size(theme, {width, area.height() - level_top}, n);
        layout.level_labels = layout.cell_px.x >= widest + 0.5F * theme.gap_px;
        if (!layout.level_labels) {
            layout.cell_px = cell_size(theme, {width, area.height() - top}, n);
        }
        const ImVec2 bare = cell_size(theme, {width, area.height()}, n);
        // In a low pane, a name for every row is worth more than names of columns, which are the
        // same.
        const bool names_rows = layout.cell_px.y < text_px * 1.1F && bare.y >= text_px * 1.1F;
        layout.column_labels = layout.cell_px.x >= text_px * 1.1F && !names_rows;
        if (!layout.column_labels) {
            layout.cell_px = bare;
            layout.level_labels = false;
        }
        layout.has_values =
            value_px.x > 0.0F && layout.cell_px.x >= value_px.x && layout.cell_px.y >= value_px.y;
        return layout;
    };
    bool with_scale = area.width() > left + right + area.height() * 0.4F;
    MatrixLayout layout = sized(with_scale);
    // Numbers make the scale unnecessary.
    if (with_scale && !layout.has_values && sized(false).has_values) {
        with_scale = false;
        layout = sized(false);
    }
    const auto objects = static_cast<float>(std::max<std::size_t>(n, 1));
    const ImVec2 extent = layout.cell_px * objects;
    const float begin = !layout.column_labels ? 0.0F : layout.level_labels ? level_top : top;
    layout.cells = rect_at({std::floor(area.min.x + left), std::floor(area.min.y + begin)}, extent);
    const float least = std::max(std::min(extent.x, extent.y), 1.0F);
    layout.shown = std::min({n, kMostCells, static_cast<std::size_t>(least)});
    layout.label_step = layout.cell_px.y > 0.0F
                            ? static_cast<std::size_t>(std::ceil(text_px * 1.1F / layout.cell_px.y))
                            : 0;
    if (with_scale) {
        layout.scale = rect_at({layout.cells.max.x + 2.0F * theme.gap_px, layout.cells.min.y},
                               {theme.gap_px, std::min(extent.y, 160.0F * theme.scale)});
    } else {
        const Rect line =
            rect_at({layout.cells.min.x, layout.cells.max.y + theme.gap_px}, {extent.x, text_px});
        if (line.max.y <= area.max.y) layout.scale_below = line;
    }
    return layout;
}

std::optional<std::size_t> row_at(const MatrixLayout& layout, std::size_t n, float offset_px) {
    return index_at(layout.cell_px.y, n, offset_px);
}

std::optional<std::size_t> column_at(const MatrixLayout& layout, std::size_t n, float offset_px) {
    return index_at(layout.cell_px.x, n, offset_px);
}

}  // namespace tact
