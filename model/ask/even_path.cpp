#include "model/ask/even_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "model/common/parallel.h"
#include "model/dtw/dtw.h"
#include "model/perceptual_model/rhythm_envelope.h"

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

namespace {

constexpr std::size_t kCoarse = 10;
// Envelopes that differ by less than this, a sample on average, differ by rounding.
constexpr double kNothing = 1e-6;

}  // namespace

PathDistances::PathDistances(const StepsQuestion& question, const StepsOptions& options)
    : question_(question),
      options_(options),
      samples_(std::max(sample_count(question.from.duration_s, kModelRateHz),
                        sample_count(question.to.duration_s, kModelRateHz))),
      morph_(question.from, question.to) {}

Pattern PathDistances::at(double share) const { return morph_.at(share); }

bool PathDistances::prepare(const std::vector<double>& shares) {
    std::vector<double> missing;
    for (const double share : shares) {
        if (!places_.contains(share)) missing.push_back(share);
    }
    std::ranges::sort(missing);
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    std::vector<Waveform> waveforms(missing.size());
    parallel_for(missing.size(), options_.threads, options_.stop,
                 [&](std::size_t k) { waveforms[k] = padded(render(at(missing[k])), samples_); });
    if (options_.stop.stop_requested()) return false;
    PredictOptions predicting;
    predicting.threads = options_.threads;
    predicting.stop = options_.stop;
    const auto codes = pattern_codes(waveforms, question_.model, predicting);
    if (codes.size() != missing.size()) return false;
    for (std::size_t k = 0; k < missing.size(); ++k) {
        places_[missing[k]] = {codes[k], decimated(codes[k]->envelope, kCoarse, samples_)};
    }
    return true;
}

std::vector<double> PathDistances::nc_of(const Pairs& pairs) const {
    std::vector<double> distances(pairs.size());
    parallel_for(pairs.size(), options_.threads, options_.stop, [&](std::size_t k) {
        distances[k] = nc_dissimilarity(places_.at(pairs[k].first).code->neural,
                                        places_.at(pairs[k].second).code->neural,
                                        question_.model.channel_weight);
    });
    return distances;
}

std::vector<double> PathDistances::oc_of(const Pairs& pairs, bool exact) const {
    std::vector<SignalPair> signals;
    for (const auto& [a, b] : pairs) {
        const Place& first = places_.at(a);
        const Place& second = places_.at(b);
        if (exact) {
            signals.push_back(envelopes_of(*first.code, *second.code));
        } else {
            const std::size_t blocks = (samples_ + kCoarse - 1) / kCoarse;
            signals.push_back({first.coarse, second.coarse, blocks, blocks});
        }
    }
    auto distances =
        dtw(signals, {options_.threads, question_.model.envelope.waiting_cost, options_.stop, {}});
    if (!exact) {
        for (double& distance : distances) distance *= static_cast<double>(kCoarse);
    }
    return distances;
}

std::vector<double> PathDistances::of(const Pairs& pairs, bool exact) const {
    std::vector<double> sum(pairs.size(), 0.0);
    if (nc_scale_ > 0.0) {
        const std::vector<double> nc = nc_of(pairs);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += nc_scale_ * nc[k];
    }
    if (oc_scale_ > 0.0) {
        const std::vector<double> oc = oc_of(pairs, exact);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += oc_scale_ * oc[k];
    }
    return sum;
}

void PathDistances::scale_by(const Pairs& pairs) {
    if (pairs.empty() || question_.measure != StepMeasure::pm) return scale_to(1.0, 1.0);
    const std::vector<double> nc = nc_of(pairs);
    const std::vector<double> oc = oc_of(pairs, false);
    const auto widest = std::ranges::max_element(oc) - oc.begin();
    const Pairs one{pairs[static_cast<std::size_t>(widest)]};
    scale_to(*std::ranges::max_element(nc), oc_of(one, true).front());
}

void PathDistances::scale_to(double largest_nc, double largest_oc) {
    if (question_.measure != StepMeasure::pm) {
        nc_scale_ = question_.measure == StepMeasure::nc ? 1.0 : 0.0;
        oc_scale_ = question_.measure == StepMeasure::oc ? 1.0 : 0.0;
        return;
    }
    const double nothing = kNothing * static_cast<double>(samples_);
    nc_scale_ = largest_nc > 0.0 ? question_.model.nc_weight / largest_nc : 0.0;
    oc_scale_ = largest_oc > nothing ? question_.model.oc_weight / largest_oc : 0.0;
}

namespace {

constexpr std::size_t kParts = 32;
constexpr int kBisections = 4;  // of as many parts, where the way goes farthest
constexpr double kSmallestJump = 1e-5;

PathDistances::Pairs all_pairs_of(const std::vector<double>& shares) {
    PathDistances::Pairs pairs;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        for (std::size_t j = i + 1; j < shares.size(); ++j) {
            pairs.emplace_back(shares[i], shares[j]);
        }
    }
    return pairs;
}

// Halves the parts over which the way goes farthest; false when stopped.
bool bisect(PathDistances& path, std::vector<double>& shares) {
    const auto pairs = neighbours_of(shares);
    const std::vector<double> far = path.of(pairs, false);
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t k) { return far[k]; });
    for (std::size_t k = 0; k < kParts / 2; ++k) {
        shares.push_back(0.5 * (pairs[order[k]].first + pairs[order[k]].second));
    }
    std::ranges::sort(shares);
    return path.prepare(shares);
}

}  // namespace

PathDistances::Pairs neighbours_of(const std::vector<double>& shares) {
    PathDistances::Pairs pairs;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        pairs.emplace_back(shares[k], shares[k + 1]);
    }
    return pairs;
}

bool look_over(PathDistances& path, PathOverview& overview) {
    for (std::size_t k = 0; k <= kParts; ++k) {
        overview.shares.push_back(static_cast<double>(k) / static_cast<double>(kParts));
    }
    if (!path.prepare(overview.shares)) return false;
    path.scale_by(all_pairs_of(overview.shares));
    for (int round = 0; round < kBisections; ++round) {
        if (!bisect(path, overview.shares)) return false;
    }
    measure(path, overview);
    return true;
}

void measure(const PathDistances& path, PathOverview& overview) {
    const std::size_t n = overview.shares.size();
    const std::vector<double> flat = path.of(all_pairs_of(overview.shares), false);
    overview.coarse.assign(n * n, 0.0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) overview.coarse[i * n + j] = flat[at++];
    }
}

// Halves where more of the way is, until a jump is all that is left.
std::optional<PathJump> largest_jump(PathDistances& path, const PathOverview& overview) {
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

}  // namespace tact
