#include "model/map/isotonic.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

namespace {

// Below this a weight counts as "next to none": such a value follows its neighbours, and 0/0 is
// avoided.
constexpr double kLeastWeight = 1e-100;

// A new value joins the pools before it as long as their mean exceeds its own. Means are compared
// crosswise, sum_a w_b > sum_b w_a, which spares a division per value. Pool 0 is a wall no value
// joins: -inf w > sum 0 is never true.
void pool_violators(std::span<double> values, std::span<const double> weights,
                    std::vector<FitScratch::Pool>& pools) {
    pools.resize(values.size() + 1);
    FitScratch::Pool* top = pools.data();
    *top = {-std::numeric_limits<double>::infinity(), 0.0, 0};
    for (std::size_t k = 0; k < values.size(); ++k) {
        double weight = weights.empty() ? 1.0 : std::max(weights[k], kLeastWeight);
        double sum = values[k] * weight;
        while (top->sum * weight > sum * top->weight) {
            sum += top->sum;
            weight += top->weight;
            --top;
        }
        *++top = {sum, weight, k + 1};
    }
    std::size_t first = 0;
    for (const FitScratch::Pool* pool = pools.data() + 1; pool <= top; ++pool) {
        // A pool of one keeps its bits.
        const double mean = pool->end - first == 1 ? values[first] : pool->sum / pool->weight;
        for (; first < pool->end; ++first) values[first] = mean;
    }
}

// Runs of equal dissimilarities, single ones among them: the end of each in `ascending`.
std::vector<std::size_t> level_ends(const PairOrder& order) {
    std::vector<std::size_t> ends;
    std::size_t next = 0;
    for (const auto& [first, end] : order.ties) {
        while (next < first) ends.push_back(++next);
        ends.push_back(end);
        next = end;
    }
    while (next < order.ascending.size()) ends.push_back(++next);
    return ends;
}

// Secondary and tertiary ties: the means of the levels are fitted, each with the weight of its
// pairs.
void fit_levels(const PairOrder& order, std::span<const double> distances, Ties ties,
                std::span<double> fitted) {
    const std::vector<std::size_t> ends = level_ends(order);
    std::vector<double> means;
    std::vector<double> counts;
    std::size_t first = 0;
    for (const std::size_t end : ends) {
        double sum = 0.0;
        for (std::size_t k = first; k < end; ++k) sum += distances[order.ascending[k]];
        counts.push_back(static_cast<double>(end - first));
        means.push_back(sum / counts.back());
        first = end;
    }
    const std::vector<double> levels = monotone_fit(means, counts);
    first = 0;
    for (std::size_t level = 0; level < ends.size(); ++level) {
        for (; first < ends[level]; ++first) {
            const std::size_t p = order.ascending[first];
            const double spread = ties == Ties::tertiary ? distances[p] - means[level] : 0.0;
            fitted[p] = levels[level] + spread;
        }
    }
}

}  // namespace

std::vector<double> monotone_fit(std::span<const double> values, std::span<const double> weights) {
    assert((weights.empty() || weights.size() == values.size()) && "one weight per value");
    std::vector<double> fitted(values.begin(), values.end());
    std::vector<FitScratch::Pool> pools;
    pool_violators(fitted, weights, pools);
    return fitted;
}

std::vector<double> disparities(std::span<const double> dissimilarities,
                                std::span<const double> distances, Ties ties) {
    assert(dissimilarities.size() == distances.size() && "one distance per dissimilarity");
    const PairOrder order = order_pairs(dissimilarities);
    std::vector<double> fitted(distances.size(), std::numeric_limits<double>::quiet_NaN());
    if (ties != Ties::primary) {
        fit_levels(order, distances, ties, fitted);
        return fitted;
    }
    FitScratch scratch = fit_scratch(order);
    fit_disparities(order, distances, scratch, fitted);
    return fitted;
}

double stress1(std::span<const double> distances, std::span<const double> fitted) {
    assert(distances.size() == fitted.size() && "one disparity per distance");
    double residual = 0.0;
    double size = 0.0;
    for (std::size_t p = 0; p < distances.size(); ++p) {
        if (std::isnan(fitted[p])) continue;
        const double miss = distances[p] - fitted[p];
        residual += miss * miss;
        size += distances[p] * distances[p];
    }
    return size > 0.0 ? std::sqrt(residual / size) : 0.0;
}

std::string stress_label(double stress1) {
    if (stress1 < 1e-6) return "perfect";
    if (stress1 <= 0.025) return "excellent";
    if (stress1 <= 0.05) return "good";
    if (stress1 <= 0.10) return "fair";
    return "poor";
}

PairOrder order_pairs(std::span<const double> dissimilarities) {
    const std::vector<KeyedPlace> sorted = by_size(dissimilarities);
    PairOrder order;
    order.ascending.reserve(sorted.size());
    for (const KeyedPlace& one : sorted) order.ascending.push_back(one.place);
    for (std::size_t p = 0; p < dissimilarities.size(); ++p) {
        if (!std::isfinite(dissimilarities[p])) order.unknown.push_back(p);
    }
    for (std::size_t first = 0; first < sorted.size(); ++order.levels) {
        std::size_t end = first + 1;
        while (end < sorted.size() && sorted[end].key == sorted[first].key) ++end;
        if (end - first > 1) order.ties.emplace_back(first, end);
        first = end;
    }
    return order;
}

FitScratch fit_scratch(const PairOrder& order) {
    FitScratch scratch{order.ascending, std::vector<double>(order.ascending.size()), {}, {}};
    scratch.pools.reserve(order.ascending.size() + 1);
    return scratch;
}

// The least squares of two generators of a cone, of which either may be left out.
void fit_interval(const PairOrder& order, std::span<const double> dissimilarities,
                  std::span<const double> distances, std::span<double> fitted) {
    if (order.ascending.empty()) return;
    const double least = dissimilarities[order.ascending.front()];
    const auto count = static_cast<double>(order.ascending.size());
    double sum = 0.0;
    double squares = 0.0;
    double sum_d = 0.0;
    double product = 0.0;
    for (const std::size_t p : order.ascending) {
        const double above = dissimilarities[p] - least;
        sum += above;
        squares += above * above;
        sum_d += distances[p];
        product += above * distances[p];
    }
    const double apart = count * squares - sum * sum;
    double slope = apart > 0.0 ? (count * product - sum * sum_d) / apart : 0.0;
    slope = std::max(slope, 0.0);
    double constant = (sum_d - slope * sum) / count;
    if (constant < 0.0) {
        constant = 0.0;
        slope = product / squares;
    }
    for (const std::size_t p : order.ascending) {
        fitted[p] = constant + slope * (dissimilarities[p] - least);
    }
}

void fit_disparities(const PairOrder& order, std::span<const double> distances, FitScratch& scratch,
                     std::span<double> fitted) {
    // Primary ties: equal dissimilarities may take any order, so they take that of the distances,
    // of equal distances the first pair first. The order of the last step is still there and mostly
    // right. Sorted is a copy, as looking up each distance would take longer than comparing it.
    for (const auto& [first, end] : order.ties) {
        const auto block = std::span(scratch.ascending).subspan(first, end - first);
        scratch.tied.clear();
        for (const std::size_t p : block) scratch.tied.emplace_back(distances[p], p);
        if (std::ranges::is_sorted(scratch.tied)) continue;
        std::ranges::sort(scratch.tied);
        for (std::size_t k = 0; k < block.size(); ++k) block[k] = scratch.tied[k].second;
    }
    for (std::size_t k = 0; k < scratch.ascending.size(); ++k) {
        scratch.values[k] = distances[scratch.ascending[k]];
    }
    pool_violators(scratch.values, {}, scratch.pools);
    for (std::size_t k = 0; k < scratch.ascending.size(); ++k) {
        fitted[scratch.ascending[k]] = scratch.values[k];
    }
}

}  // namespace tact
