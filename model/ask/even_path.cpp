#include "model/ask/even_path.h"

#include <algorithm>
#include <limits>

namespace tact {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Step {
    std::size_t from = 0;
    std::size_t to = 0;
    double distance = 0.0;
    double extent = 0.0;  // of shares, squared
};

// By layer, only those that continue.
using Steps = std::vector<std::vector<Step>>;

Steps steps_of(const std::vector<std::vector<double>>& layers, const LayerDistance& distance) {
    Steps steps(layers.size() - 1);
    for (std::size_t layer = 0; layer + 1 < layers.size(); ++layer) {
        for (std::size_t i = 0; i < layers[layer].size(); ++i) {
            for (std::size_t j = 0; j < layers[layer + 1].size(); ++j) {
                const double on = layers[layer + 1][j] - layers[layer][i];
                const double apart = on > 0.0 ? distance(layer, i, j) : 0.0;
                if (apart > 0.0) steps[layer].push_back({i, j, apart, on * on});
            }
        }
    }
    return steps;
}

std::vector<double> values_of(const Steps& steps) {
    std::vector<double> values;
    for (const auto& layer : steps) {
        for (const Step& step : layer) values.push_back(step.distance);
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    // More would take minutes, and bring nothing that the next round of narrowing does not.
    constexpr std::size_t kMost = 1500;
    if (values.size() <= kMost) return values;
    std::vector<double> fewer;
    for (std::size_t k = 0; k < kMost; ++k) fewer.push_back(values[k * values.size() / kMost]);
    return fewer;
}

// What it costs to come to each place of the last layer, and from where.
struct Costs {
    std::vector<std::vector<double>> cost;
    std::vector<std::vector<std::size_t>> before;
};

// By steps within [least, most]: the largest distance, or the sum of squared extents.
Costs costs_of(const std::vector<std::vector<double>>& layers, const Steps& steps, double least,
               double most, bool by_extent) {
    Costs result;
    for (const auto& layer : layers) {
        result.cost.emplace_back(layer.size(), kNever);
        result.before.emplace_back(layer.size(), 0);
    }
    std::ranges::fill(result.cost[0], 0.0);
    for (std::size_t layer = 0; layer < steps.size(); ++layer) {
        for (const Step& step : steps[layer]) {
            if (step.distance < least || step.distance > most) continue;
            const double so_far = result.cost[layer][step.from];
            const double cost = by_extent ? so_far + step.extent : std::max(so_far, step.distance);
            if (!(cost < result.cost[layer + 1][step.to])) continue;
            result.cost[layer + 1][step.to] = cost;
            result.before[layer + 1][step.to] = step.from;
        }
    }
    return result;
}

// The largest distance of a way to its smallest.
double ratio_of(const std::vector<std::size_t>& chosen, const LayerDistance& distance) {
    double least = kNever;
    double most = 0.0;
    for (std::size_t layer = 0; layer + 1 < chosen.size(); ++layer) {
        const double apart = distance(layer, chosen[layer], chosen[layer + 1]);
        least = std::min(least, apart);
        most = std::max(most, apart);
    }
    return most / least;
}

std::vector<std::size_t> way_to(const Costs& costs, std::size_t last) {
    std::vector<std::size_t> chosen{last};
    for (std::size_t layer = costs.before.size() - 1; layer > 0; --layer) {
        chosen.push_back(costs.before[layer][chosen.back()]);
    }
    std::ranges::reverse(chosen);
    return chosen;
}

}  // namespace

EvenPath even_path(const std::vector<std::vector<double>>& layers, const LayerDistance& distance,
                   double tolerance) {
    EvenPath best{{}, kNever};
    double least_extent = kNever;
    const Steps steps = steps_of(layers, distance);
    for (const double least : values_of(steps)) {
        const Costs any = costs_of(layers, steps, least, kNever, false);
        const auto end = std::ranges::min_element(any.cost.back());
        if (*end == kNever) break;  // nor with a larger one
        const double ratio = *end / least;
        const auto last = static_cast<std::size_t>(end - any.cost.back().begin());
        if (ratio > 1.0 + tolerance) {
            if (least_extent == kNever && ratio < best.ratio) best = {way_to(any, last), ratio};
            continue;
        }
        const double most = least * (1.0 + tolerance);
        const Costs even = costs_of(layers, steps, least, most, true);
        const auto nearest = std::ranges::min_element(even.cost.back());
        if (!(*nearest < least_extent)) continue;
        least_extent = *nearest;
        const auto place = static_cast<std::size_t>(nearest - even.cost.back().begin());
        best.chosen = way_to(even, place);
        best.ratio = ratio_of(best.chosen, distance);
    }
    return best;
}

}  // namespace tact
