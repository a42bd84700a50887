#include "model/ask/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/ask/even_path.h"
#include "model/ask/path_distances.h"

namespace tact {

namespace {

constexpr std::size_t kParts = 64;
constexpr int kNarrowings = 7;
constexpr int kHalfWindow = 4;      // places to either side, in a window
constexpr double kAimedAt = 0.015;  // of the tolerance some is left for what is coarse
constexpr double kSmallestJump = 1e-5;

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
    PathDistances::Pairs pairs;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        pairs.emplace_back(shares[k], shares[k + 1]);
    }
    return path.of(pairs, true);
}

std::vector<double> parts_of_way() {
    std::vector<double> shares;
    for (std::size_t k = 0; k <= kParts; ++k) {
        shares.push_back(static_cast<double>(k) / static_cast<double>(kParts));
    }
    return shares;
}

// The whole way in each layer but the ends'.
struct Overview {
    std::vector<double> shares = parts_of_way();
    std::vector<double> coarse;  // of all pairs, row by row; the lower half is 0
};

bool look_over(PathDistances& path, Overview& overview) {
    if (!path.prepare(overview.shares)) return false;
    const std::size_t n = overview.shares.size();
    PathDistances::Pairs pairs;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            pairs.emplace_back(overview.shares[i], overview.shares[j]);
        }
    }
    path.scale_by(pairs);
    const std::vector<double> flat = path.of(pairs, false);
    overview.coarse.assign(n * n, 0.0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) overview.coarse[i * n + j] = flat[at++];
    }
    return true;
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

std::vector<double> first_places(const Overview& overview, std::size_t count) {
    Layers layers(count, overview.shares);
    layers.front() = {0.0};
    layers.back() = {1.0};
    const std::size_t n = overview.shares.size();
    const auto row_of = [n](double share) {
        return static_cast<std::size_t>(std::lround(share * static_cast<double>(n - 1)));
    };
    const EvenPath way = even_path(
        layers,
        [&](std::size_t layer, std::size_t i, std::size_t j) {
            return overview.coarse[row_of(layers[layer][i]) * n + row_of(layers[layer + 1][j])];
        },
        kAimedAt);
    return way.chosen.empty() ? evenly(count) : picked_of(layers, way.chosen);
}

// Places around each that are nearer to it each round.
Layers windows_around(const std::vector<double>& shares, double grain) {
    Layers layers;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        layers.emplace_back();
        const bool is_end = k == 0 || k + 1 == shares.size();
        const int reach = is_end ? 0 : kHalfWindow;
        for (int step = -reach; step <= reach; ++step) {
            const double share = shares[k] + step * grain;
            if (is_end || (share > 0.0 && share < 1.0)) layers.back().push_back(share);
        }
    }
    return layers;
}

// Better places near these, by coarse distances scaled to what is known exactly; empty when
// stopped.
std::vector<double> narrowed(PathDistances& path, const std::vector<double>& shares,
                             const std::vector<double>& exact, double grain) {
    const Layers layers = windows_around(shares, grain);
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

// Halves where more of the way is, until a jump is all that is left.
std::optional<PathJump> largest_jump(PathDistances& path, const Overview& overview) {
    const std::size_t n = overview.shares.size();
    std::size_t worst = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        if (overview.coarse[k * n + k + 1] > overview.coarse[worst * n + worst + 1]) worst = k;
    }
    double low = overview.shares[worst];
    double high = overview.shares[worst + 1];
    while (high - low > kSmallestJump) {
        const double middle = 0.5 * (low + high);
        if (!path.prepare({low, middle, high})) return std::nullopt;
        const auto halves = path.of({{low, middle}, {middle, high}}, false);
        (halves[0] >= halves[1] ? high : low) = middle;
    }
    return PathJump{low, path.of({{low, high}}, true).front()};
}

struct Placed {
    std::vector<double> shares;
    std::vector<double> exact;
    double uneven = std::numeric_limits<double>::infinity();
};

// The most even of all rounds; its shares are empty when stopped.
Placed placed(PathDistances& path, const StepsQuestion& question, const Overview& overview,
              const std::function<void(double)>& progress) {
    Placed best;
    std::vector<double> shares = first_places(overview, question.count);
    double grain = 1.0 / static_cast<double>(kParts * kHalfWindow);
    for (int round = 0; round < kNarrowings; ++round, grain *= 0.25) {
        if (!path.prepare(shares)) return {};
        const std::vector<double> exact = exact_neighbours(path, shares);
        const double uneven = unevenness(exact);
        if (best.shares.empty() || uneven < best.uneven) best = {shares, exact, uneven};
        if (progress) progress(0.4 + 0.4 * (round + 1) / kNarrowings);
        if (uneven <= 2.0 * kAimedAt || question.count == 2) break;
        shares = narrowed(path, best.shares, best.exact, grain);
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
    Overview overview;
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
