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

// What is there while names are placed one after the other.
struct Placing {
    const LabelField& field;
    CellGrid grid;
    float widest_radius = 0.0F;
    std::vector<Rect> taken;  // other things, and names with what they keep free around them
    std::vector<Leader> leaders;
};

float distance_to_edge(const Disc& disc, const Rect& name) {
    return std::sqrt(squared_distance(name, disc.centre)) - disc.radius;
}

// Over a point, or nearer to another one than to its own: then it would seem to be that one's.
bool belongs_to_another(const Placing& placing, std::size_t own, const Rect& name) {
    constexpr float kTiePx = 1.0F;  // points in one place have names on either side
    const LabelField& field = placing.field;
    const Disc& disc = field.discs[own];
    const bool led = leader(disc, name, field.gap_px).has_value();
    const float least = led ? 0.0F : std::max(0.0F, distance_to_edge(disc, name) - kTiePx);
    const CellGrid& grid = placing.grid;
    const Rect near = inset(name, -placing.widest_radius - least);
    for (int row = cell_row(grid, near.min.y); row <= cell_row(grid, near.max.y); ++row) {
        const int first = row * grid.columns;
        const auto begin = static_cast<std::size_t>(first + cell_column(grid, near.min.x));
        const auto end = static_cast<std::size_t>(first + cell_column(grid, near.max.x));
        for (std::size_t k = grid.begin[begin]; k < grid.begin[end + 1]; ++k) {
            const std::size_t other = grid.points[k];
            const float kept = other == own ? 0.0F : least;
            if (distance_to_edge(field.discs[other], name) < kept) return true;
        }
    }
    return false;
}

// Whether a line meets a rectangle: Liang & Barsky 1984.
bool crosses(const Leader& line, const Rect& r) {
    float first = 0.0F;
    float last = 1.0F;
    const auto cut = [&](float from, float way, float low, float high) {
        if (way == 0.0F) return from > low && from < high;
        const float a = (low - from) / way;
        const float b = (high - from) / way;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
        return first < last;
    };
    const ImVec2 way = line.to - line.from;
    return cut(line.from.x, way.x, r.min.x, r.max.x) && cut(line.from.y, way.y, r.min.y, r.max.y);
}

// Over a point that it does not begin in.
bool passes_over(const Leader& line, const Disc& disc) {
    const ImVec2 way = line.to - line.from;
    const ImVec2 to_disc = disc.centre - line.from;
    if (std::hypot(to_disc.x, to_disc.y) < disc.radius + 2.0F) return false;
    const float length2 = std::max(way.x * way.x + way.y * way.y, 1e-6F);
    const float along = (to_disc.x * way.x + to_disc.y * way.y) / length2;
    const ImVec2 off = to_disc - way * std::clamp(along, 0.0F, 1.0F);
    return std::hypot(off.x, off.y) < disc.radius;
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

bool is_free(const Placing& placing, std::size_t disc, const Rect& name) {
    const auto meets = [&name](const Rect& other) { return other.intersects(name); };
    const auto struck = [&name](const Leader& line) { return crosses(line, name); };
    return placing.field.pane.contains(name) && std::ranges::none_of(placing.taken, meets) &&
           std::ranges::none_of(placing.leaders, struck) &&
           !belongs_to_another(placing, disc, name);
}

// Its line must cross no name; better no point either.
bool is_led_clearly(const Placing& placing, std::size_t disc, const Rect& name, bool over_points) {
    const auto line = leader(placing.field.discs[disc], name, placing.field.gap_px);
    if (!line) return true;
    const auto struck = [&line](const Rect& other) { return crosses(*line, other); };
    if (std::ranges::any_of(placing.taken, struck)) return false;
    const auto passed = [&line](const Disc& other) { return passes_over(*line, other); };
    return over_points || std::ranges::none_of(placing.field.discs, passed);
}

std::optional<Rect> place_beside(const Placing& placing, const LabelRequest& request) {
    const Disc& disc = placing.field.discs[request.disc];
    for (const float share : {1.0F, 0.85F, 0.7F, 0.6F, 0.5F}) {
        const ImVec2 size{std::floor(share * request.size.x), request.size.y};
        if (share < 1.0F && (request.least_px <= 0.0F || size.x < request.least_px)) break;
        const auto level = places(disc, share < 1.0F ? size : request.size, placing.field.gap_px);
        for (const std::size_t side : {0U, 1U}) {
            if (is_free(placing, request.disc, level[side])) return level[side];
        }
    }
    const auto all = places(disc, request.size, placing.field.gap_px);
    const auto found = std::find_if(all.begin() + 2, all.end(), [&](const Rect& name) {
        return is_free(placing, request.disc, name);
    });
    return found == all.end() ? std::nullopt : std::optional(*found);
}

std::optional<Rect> place_far(const Placing& placing, const LabelRequest& request) {
    const LabelField& field = placing.field;
    if (field.far_px <= 0.0F) return std::nullopt;
    for (const bool over_points : {false, true}) {
        for (const float times : {1.0F, 2.0F, 3.0F}) {
            const auto all = places(field.discs[request.disc], request.size,
                                    field.gap_px + times * field.far_px);
            const auto found = std::ranges::find_if(all, [&](const Rect& name) {
                return is_free(placing, request.disc, name) &&
                       is_led_clearly(placing, request.disc, name, over_points);
            });
            if (found != all.end()) return *found;
        }
    }
    return std::nullopt;
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
    Placing placing{
        field, sorted_into_cells(field), 0.0F, {field.occupied.begin(), field.occupied.end()}, {}};
    for (const Disc& d : field.discs)
        placing.widest_radius = std::max(placing.widest_radius, d.radius);
    std::vector<std::optional<Rect>> result;
    for (const LabelRequest& request : requests) {
        std::optional<Rect> name = place_beside(placing, request);
        if (!name) name = place_far(placing, request);
        result.push_back(name);
        if (!name) continue;
        placing.taken.push_back({name->min - field.apart_px, name->max + field.apart_px});
        if (const auto line = leader(field.discs[request.disc], *name, field.gap_px))
            placing.leaders.push_back(*line);
    }
    return result;
}

}  // namespace tact
