#include "model/metrics/raw_dtw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/dtw/dtw.h"

namespace tact {

namespace {

// The best path to a cell.
struct Path {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t length = 0;
};

// Ties: the diagonal's path; between the two others the choice must not depend on which signal is
// called x.
const Path& best_of(const Path& diagonal, const Path& above, const Path& left) {
    const Path* straight = &above;
    if (left.cost < above.cost || (left.cost == above.cost && left.length < above.length)) {
        straight = &left;
    }
    return diagonal.cost <= straight->cost ? diagonal : *straight;
}

struct Columns {
    std::size_t first;
    std::size_t end;
};

// Those of a row within the band. The rows are the longer signal's, so that the line climbs at
// most one column a row.
Columns columns_of(std::size_t row, std::size_t rows, std::size_t columns,
                   const RawDtwParams& params) {
    if (!params.band_samples || rows < 2) return {0, columns};
    const double reach = std::max(0.5, static_cast<double>(*params.band_samples));
    const double line =
        static_cast<double>(row) * static_cast<double>(columns - 1) / static_cast<double>(rows - 1);
    const double first = std::max(0.0, std::ceil(line - reach));
    const double last = std::min(static_cast<double>(columns - 1), std::floor(line + reach));
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last) + 1};
}

// Row by row as the textbooks have it; path[j + 1] belongs to column j, path[0] lies outside.
Path best_path(std::span<const double> longer, std::span<const double> shorter,
               const RawDtwParams& params) {
    std::vector<Path> above(shorter.size() + 1);
    std::vector<Path> row(shorter.size() + 1);
    above[0].cost = 0.0;  // the path starts at no cost before the first cell
    for (std::size_t i = 0; i < longer.size(); ++i) {
        std::ranges::fill(row, Path{});
        const auto [first, end] = columns_of(i, longer.size(), shorter.size(), params);
        for (std::size_t j = first; j < end; ++j) {
            const Path& before = best_of(above[j], above[j + 1], row[j]);
            const double apart = std::abs(longer[i] - shorter[j]);
            const double cost = params.cost == DtwCost::squared ? apart * apart : apart;
            row[j + 1] = {before.cost + cost, before.length + 1};
        }
        std::swap(above, row);
    }
    return above.back();
}

}  // namespace

bool is_plain(const RawDtwParams& params) {
    return params.cost == DtwCost::absolute && !params.takes_root && !params.band_samples &&
           params.normalisation != DtwNormalisation::path_length;
}

double normalised_dtw(double distance, std::size_t x_samples, std::size_t y_samples,
                      const RawDtwParams& params) {
    const std::size_t both = x_samples + y_samples;
    if (params.normalisation != DtwNormalisation::sum_of_lengths || both == 0) return distance;
    return distance / static_cast<double>(both);
}

double raw_dtw(std::span<const double> x, std::span<const double> y, const RawDtwParams& params) {
    if (is_plain(params)) return normalised_dtw(dtw(x, y), x.size(), y.size(), params);
    if (x.empty() && y.empty()) return 0.0;
    if (x.empty() || y.empty()) return std::numeric_limits<double>::infinity();
    const bool x_is_longer = x.size() >= y.size();
    const Path path = best_path(x_is_longer ? x : y, x_is_longer ? y : x, params);
    const double distance = params.takes_root ? std::sqrt(path.cost) : path.cost;
    if (params.normalisation == DtwNormalisation::path_length) {
        return distance / static_cast<double>(path.length);
    }
    return normalised_dtw(distance, x.size(), y.size(), params);
}

}  // namespace tact
