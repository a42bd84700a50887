#include "model/ask/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/ask/even_path.h"
#include "model/ask/path_distances.h"
#include "model/ask/path_overview.h"

namespace tact {

namespace {

constexpr int kNarrowings = 7;
constexpr int kHalfWindow = 4;      // places to either side, in a window
constexpr double kAimedAt = 0.015;  // of the tolerance some is left for what is coarse

using Layers = std::vector<std::vector<double>>;
using Distances = std::vector<std::vector<double>>;  // of a layer's places to the next one's

// Asks for all pairs of neighbouring layers at once; empty when stopped.
Distances distances_of(PathDistances& path, const Layers& layers) {
    std::vector<double> all;
    PathDistances::Pairs pairs;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        all.insert(all.end(), layers[layer].begin(), layers[layer].end());
        if (layer + 1 == layers.size()) break;
        for (const double a : layers[layer]) {
            for (const double b : layers[layer + 1]) pairs.emplace_back(a, b);
        }
    }
    if (!path.prepare(all)) return {};
    const std::vector<double> flat = path.of(pairs, false);
    Distances distances;
    auto at = flat.begin();
    for (std::size_t layer = 0; layer + 1 < layers.size(); ++layer) {
        const auto size =
            static_cast<std::ptrdiff_t>(layers[layer].size() * layers[layer + 1].size());
        distances.emplace_back(at, at + size);
        at += size;
    }
    return distances;
}

std::vector<double> exact_neighbours(PathDistances& path, const std::vector<double>& shares) {
    return path.of(neighbours_of(shares), true);
}

// Even parts, where no distance is known by which they could be placed.
std::vector<double> evenly(std::size_t count) {
    std::vector<double> shares;
    for (std::size_t k = 0; k < count; ++k) {
        shares.push_back(static_cast<double>(k) / static_cast<double>(count - 1));
    }
    return shares;
}

std::vector<double> picked_of(const Layers& layers, const std::vector<std::size_t>& chosen) {
    std::vector<double> shares;
    for (std::size_t k = 0; k < chosen.size(); ++k) shares.push_back(layers[k][chosen[k]]);
    return shares;
}

std::vector<double> first_places(const PathOverview& overview, std::size_t count) {
    Layers layers(count, overview.shares);
    layers.front() = {0.0};
    layers.back() = {1.0};
    const std::size_t n = overview.shares.size();
    const auto row_of = [&](std::size_t layer, std::size_t i) {
        return layer == 0 ? 0 : layer + 1 == count ? n - 1 : i;
    };
    const EvenPath way = even_path(
        layers,
        [&](std::size_t layer, std::size_t i, std::size_t j) {
            return overview.coarse[row_of(layer, i) * n + row_of(layer + 1, j)];
        },
        kAimedAt);
    return way.chosen.empty() ? evenly(count) : picked_of(layers, way.chosen);
}

// How far it is from each to what was looked at beside it.
std::vector<double> grains_of(const PathOverview& overview, const std::vector<double>& shares) {
    std::vector<double> grains;
    for (const double share : shares) {
        const auto above = std::ranges::upper_bound(overview.shares, share);
        const auto below = std::ranges::lower_bound(overview.shares, share);
        const double high = above == overview.shares.end() ? 1.0 : *above;
        const double low = below == overview.shares.begin() ? 0.0 : *(below - 1);
        grains.push_back(std::max(high - share, share - low) / kHalfWindow);
    }
    return grains;
}

// Places around each, nearer to it each round.
Layers windows_around(const std::vector<double>& shares, const std::vector<double>& grains) {
    Layers layers;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        layers.emplace_back();
        const bool is_end = k == 0 || k + 1 == shares.size();
        const int reach = is_end ? 0 : kHalfWindow;
        for (int step = -reach; step <= reach; ++step) {
            const double share = shares[k] + step * grains[k];
            if (is_end || (share > 0.0 && share < 1.0)) layers.back().push_back(share);
        }
    }
    return layers;
}

// Better places near these, by coarse distances scaled to what is known exactly; empty when
// stopped.
std::vector<double> narrowed(PathDistances& path, const std::vector<double>& shares,
                             const std::vector<double>& exact, const std::vector<double>& grains) {
    const Layers layers = windows_around(shares, grains);
    const Distances coarse = distances_of(path, layers);
    if (coarse.empty()) return {};
    std::vector<double> correction;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        const double here = path.of({{shares[k], shares[k + 1]}}, false).front();
        correction.push_back(here > 0.0 ? exact[k] / here : 1.0);
    }
    const EvenPath way = even_path(
        layers,
        [&](std::size_t layer, std::size_t i, std::size_t j) {
            return correction[layer] * coarse[layer][i * layers[layer + 1].size() + j];
        },
        kAimedAt);
    return way.chosen.empty() ? shares : picked_of(layers, way.chosen);
}

struct Placed {
    std::vector<double> shares;
    std::vector<double> exact;
    double uneven = std::numeric_limits<double>::infinity();
};

// The most even of all rounds; its shares are empty when stopped.
Placed placed(PathDistances& path, const StepsQuestion& question, const PathOverview& overview,
              const std::function<void(double)>& progress) {
    Placed best;
    std::vector<double> shares = first_places(overview, question.count);
    double finer = 1.0;
    for (int round = 0; round < kNarrowings; ++round, finer *= 0.4) {
        if (!path.prepare(shares)) return {};
        const std::vector<double> exact = exact_neighbours(path, shares);
        const double uneven = unevenness(exact);
        if (best.shares.empty() || uneven < best.uneven) best = {shares, exact, uneven};
        if (progress) progress(0.4 + 0.4 * (round + 1) / kNarrowings);
        if (uneven <= 2.0 * kAimedAt || question.count == 2) break;
        std::vector<double> grains = grains_of(overview, best.shares);
        for (double& grain : grains) grain *= finer;
        shares = narrowed(path, best.shares, best.exact, grains);
        if (shares.empty()) return {};
    }
    return best;
}

// The exact PM of neighbours in the set of these patterns alone; false when stopped.
bool tell_pm(const StepsQuestion& question, const StepsOptions& options, EvenSteps& steps) {
    std::vector<Waveform> waveforms;
    std::size_t longest = 0;
    for (const Pattern& pattern : steps.patterns) {
        waveforms.push_back(render(pattern));
        longest = std::max(longest, waveforms.back().samples_g.size());
    }
    for (Waveform& waveform : waveforms) waveform = padded(std::move(waveform), longest);
    PredictOptions predicting;
    predicting.threads = options.threads;
    predicting.stop = options.stop;
    const auto prediction = predict(waveforms, question.model, predicting);
    if (!prediction) return false;
    for (std::size_t k = 0; k + 1 < steps.patterns.size(); ++k) {
        steps.pm.push_back(prediction->pm(k, k + 1));
    }
    steps.largest_pm = *std::ranges::max_element(prediction->pm.condensed);
    return true;
}

}  // namespace

std::optional<EvenSteps> even_steps(const StepsQuestion& question, const StepsOptions& options) {
    PathDistances path(question, options);
    PathOverview overview;
    if (!look_over(path, overview)) return std::nullopt;
    if (options.progress) options.progress(0.4);
    const Placed found = placed(path, question, overview, options.progress);
    if (found.shares.empty()) return std::nullopt;
    EvenSteps steps;
    steps.shares = found.shares;
    steps.apart = found.exact;
    steps.uneven = found.uneven;
    steps.ends_apart = path.of({{0.0, 1.0}}, true).front();
    for (const double share : steps.shares) steps.patterns.push_back(path.at(share));
    if (!is_even(steps)) steps.jump = largest_jump(path, overview);
    if (!tell_pm(question, options, steps)) return std::nullopt;
    if (options.stop.stop_requested()) return std::nullopt;
    if (options.progress) options.progress(1.0);
    return steps;
}

}  // namespace tact
