#include "model/training/training_tally.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tact {

namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr double kBinsPerUnit = 1e5;
constexpr std::size_t kBins = 200'001;  // of values from -1 to 1

std::size_t bin_of(double value) {
    return static_cast<std::size_t>(std::clamp(value + 1.0, 0.0, 2.0) * kBinsPerUnit);
}

// Keeps the first of the points, whoever found them.
void keep_first(std::vector<GridPoint>& points) {
    std::ranges::sort(points);
    if (points.size() > kMostListedPoints) points.resize(kMostListedPoints);
}

void take_point(SearchOptimum& optimum, const TrainingGrid& grid, const GridPoint& point,
                double value) {
    if (value > optimum.value + kEqualObjective) optimum = {value, {}, 0, 0};
    optimum.value = std::max(optimum.value, value);
    optimum.points.push_back(point);
    if (optimum.points.size() >= 2 * kMostListedPoints) keep_first(optimum.points);
    ++optimum.classes;
    optimum.combinations += combinations_of(grid, point);
}

void raise(double& best, double value) {
    if (value > best) best = value;
}

void raise(std::vector<double>& best, const std::vector<double>& values) {
    for (std::size_t k = 0; k < best.size(); ++k) raise(best[k], values[k]);
}

// Where the values of the first objective lie; NaN, which has no order, is skipped.
void take_marginals(SearchTally& tally, const TrainingGrid& grid, const GridPoint& first,
                    std::span<const double> values, double top) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::isnan(values[k])) continue;
        const GridPoint point{first.layers, first.channel,
                              first.mix + static_cast<std::uint32_t>(k)};
        raise(tally.best_of_mix[point.mix], values[k]);
        tally.histogram[bin_of(values[k])] += combinations_of(grid, point);
    }
    if (first.channel == kAny) {
        for (double& best : tally.best_of_layers) raise(best, top);
        for (double& best : tally.best_of_channel) raise(best, top);
    } else {
        raise(tally.best_of_layers[first.layers], top);
        raise(tally.best_of_channel[first.channel], top);
    }
}

}  // namespace

SearchTally empty_tally(const TrainingGrid& grid, std::size_t objectives) {
    SearchTally tally;
    tally.optima.assign(objectives, {kNothing, {}, 0, 0});
    tally.best_of_layers.assign(kTrainedLayers, kNothing);
    tally.best_of_channel.assign(grid.channels.size(), kNothing);
    tally.best_of_mix.assign(grid.mixes.size(), kNothing);
    tally.histogram.assign(kBins, 0);
    return tally;
}

void take_values(SearchTally& tally, const TrainingGrid& grid, std::size_t objective,
                 GridPoint first, std::span<const double> values) {
    double top = kNothing;
    for (const double value : values) top = value > top ? value : top;
    if (objective == 0) take_marginals(tally, grid, first, values, top);
    SearchOptimum& optimum = tally.optima[objective];
    if (!(top >= optimum.value - kEqualObjective) || top == kNothing) return;
    for (const double value : values) {
        if (value >= optimum.value - kEqualObjective) take_point(optimum, grid, first, value);
        ++first.mix;
    }
}

void merge_into(SearchTally& all, SearchTally other) {
    for (std::size_t o = 0; o < all.optima.size(); ++o) {
        SearchOptimum& mine = all.optima[o];
        SearchOptimum& theirs = other.optima[o];
        if (theirs.value < mine.value - kEqualObjective || theirs.points.empty()) continue;
        if (theirs.value > mine.value + kEqualObjective) {
            mine = std::move(theirs);
            continue;
        }
        raise(mine.value, theirs.value);
        mine.points.insert(mine.points.end(), theirs.points.begin(), theirs.points.end());
        keep_first(mine.points);
        mine.classes += theirs.classes;
        mine.combinations += theirs.combinations;
    }
    raise(all.best_of_layers, other.best_of_layers);
    raise(all.best_of_channel, other.best_of_channel);
    raise(all.best_of_mix, other.best_of_mix);
    for (std::size_t k = 0; k < kBins; ++k) all.histogram[k] += other.histogram[k];
}

SearchResult result_of(const TrainingGrid& grid, SearchTally all) {
    for (SearchOptimum& optimum : all.optima) {
        keep_first(optimum.points);
        if (optimum.points.empty()) optimum.value = std::numeric_limits<double>::quiet_NaN();
    }
    return {grid,
            std::move(all.optima),
            std::move(all.best_of_layers),
            std::move(all.best_of_channel),
            std::move(all.best_of_mix),
            std::move(all.histogram)};
}

double share_near_best(const SearchResult& result, double below) {
    const double best = result.optima.front().value;
    if (std::isnan(best)) return 0.0;
    std::uint64_t near = 0;
    for (std::size_t k = bin_of(best - below); k < kBins; ++k) near += result.histogram[k];
    return static_cast<double>(near) / static_cast<double>(combination_count(result.grid.units));
}

}  // namespace tact
