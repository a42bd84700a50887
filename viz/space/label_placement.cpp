#include "viz/space/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tact {
namespace {

constexpr float kCellPx = 48.0F;

// Points sorted into square cells, so that a name is checked against its neighbourhood only.
struct CellGrid {
    Rect pane;
    int columns = 1;
    int rows = 1;
    std::vector<std::size_t> begin;  // of each cell's points in `points`, and the end
    std::vector<std::size_t> points;
};

int cell_column(const CellGrid& grid, float x) {
    return std::clamp(static_cast<int>((x - grid.pane.min.x) / kCellPx), 0, grid.columns - 1);
}

int cell_row(const CellGrid& grid, float y) {
    return std::clamp(static_cast<int>((y - grid.pane.min.y) / kCellPx), 0, grid.rows - 1);
}

// Points outside the pane are of no concern unless their discs reach in; clamping them into the
// outermost cells keeps those. Coordinates must be finite.
CellGrid sorted_into_cells(const LabelField& field) {
    CellGrid grid{field.pane, 1, 1, {}, {}};
    grid.columns = std::max(1, static_cast<int>(std::ceil(field.pane.width() / kCellPx)));
    grid.rows = std::max(1, static_cast<int>(std::ceil(field.pane.height() / kCellPx)));
    const auto cell_of = [&](const Disc& d) {
        return static_cast<std::size_t>(cell_row(grid, d.centre.y) * grid.columns +
                                        cell_column(grid, d.centre.x));
    };
    grid.begin.assign(static_cast<std::size_t>(grid.columns * grid.rows) + 1, 0);
    for (const Disc& d : field.discs) ++grid.begin[cell_of(d) + 1];
    for (std::size_t i = 1; i < grid.begin.size(); ++i) grid.begin[i] += grid.begin[i - 1];
    grid.points.resize(field.discs.size());
    std::vector<std::size_t> next = grid.begin;
    for (std::size_t i = 0; i < field.discs.size(); ++i) {
        grid.points[next[cell_of(field.discs[i])]++] = i;
    }
    return grid;
}

bool covers_a_point(const CellGrid& grid, const LabelField& field, const Rect& name,
                    float widest_radius) {
    const Rect near = inset(name, -widest_radius);
    for (int row = cell_row(grid, near.min.y); row <= cell_row(grid, near.max.y); ++row) {
        const int first = row * grid.columns;
        const auto begin = static_cast<std::size_t>(first + cell_column(grid, near.min.x));
        const auto end = static_cast<std::size_t>(first + cell_column(grid, near.max.x));
        for (std::size_t k = grid.begin[begin]; k < grid.begin[end + 1]; ++k) {
            const Disc& d = field.discs[grid.points[k]];
            if (squared_distance(name, d.centre) < d.radius * d.radius) return true;
        }
    }
    return false;
}

// Right and left first, where names read best; then the corners; then below and above.
std::array<Rect, 8> places(const Disc& disc, ImVec2 size, float gap_px) {
    const float r = disc.radius + gap_px;
    const float d = 0.7072F * disc.radius + gap_px;
    const float w = size.x;
    const float h = size.y;
    const std::array<ImVec2, 8> corners{
        ImVec2{r, -h / 2},      ImVec2{-r - w, -h / 2}, ImVec2{d, -d - h},      ImVec2{d, d},
        ImVec2{-d - w, -d - h}, ImVec2{-d - w, d},      ImVec2{-w / 2, -r - h}, ImVec2{-w / 2, r}};
    std::array<Rect, 8> result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ImVec2 corner = disc.centre + corners[i];
        // Text snaps down to whole pixels: promise where it will really be.
        result[i] = rect_at({std::floor(corner.x), std::floor(corner.y)}, size);
    }
    return result;
}

}  // namespace

std::optional<Leader> leader(const Disc& disc, const Rect& name, float gap_px) {
    const ImVec2 to{std::clamp(disc.centre.x, name.min.x, name.max.x),
                    std::clamp(disc.centre.y, name.min.y, name.max.y)};
    const ImVec2 along = to - disc.centre;
    const float length = std::hypot(along.x, along.y);
    if (length <= disc.radius + 2.0F * gap_px) return std::nullopt;
    return Leader{disc.centre + along * ((disc.radius + 1.0F) / length), to};
}

std::vector<std::optional<Rect>> place_labels(std::span<const LabelRequest> requests,
                                              const LabelField& field) {
    const CellGrid grid = sorted_into_cells(field);
    float widest_radius = 0.0F;
    for (const Disc& d : field.discs) widest_radius = std::max(widest_radius, d.radius);
    std::vector<Rect> taken(field.occupied.begin(), field.occupied.end());
    std::vector<std::optional<Rect>> result(requests.size());
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const LabelRequest& request = requests[i];
        const auto is_free = [&](const Rect& name) {
            const auto meets = [&](const Rect& other) { return other.intersects(name); };
            return field.pane.contains(name) && std::none_of(taken.begin(), taken.end(), meets) &&
                   !covers_a_point(grid, field, name, widest_radius);
        };
        for (const float off : {0.0F, field.far_px, 2.0F * field.far_px}) {
            if (result[i]) break;
            const auto all = places(field.discs[request.disc], request.size, field.gap_px + off);
            const auto free = std::find_if(all.begin(), all.end(), is_free);
            if (free != all.end()) result[i] = *free;
            if (field.far_px <= 0.0F) break;
        }
        if (result[i]) taken.push_back(*result[i]);
    }
    return result;
}

}  // namespace tact
