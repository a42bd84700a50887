#include "model/signal/short_bursts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tact {

namespace {

constexpr double kLongestS = 0.060;
constexpr double kShortestS = 0.004;
constexpr double kLeastExcess = 0.5;  // of the energy below it
constexpr double kLeastShare = 0.05;  // of the largest amplitude
constexpr double kFoot = 0.01;        // of its height: where a burst begins and ends
constexpr double kDeepValley = 0.7;   // of the lower of two heights: so they are two
constexpr double kWindowS = 0.010;    // by which the envelope is smeared
constexpr std::size_t kTremor = 4;

// The squared window of a transient of 1 s: its integral, and the spread of its times.
constexpr double kWindowEnergy = 0.6875;
constexpr double kWindowSpread = 0.20346;

struct Run {
    std::size_t first;
    std::size_t last;  // included
};

enum class Extreme { least, largest };

std::vector<double> moving(std::span<const double> x, std::size_t reach, Extreme extreme) {
    std::vector<double> result;
    result.reserve(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        const std::size_t first = k < reach ? 0 : k - reach;
        const auto part = x.subspan(first, std::min(k + reach + 1, x.size()) - first);
        result.push_back(extreme == Extreme::least ? std::ranges::min(part)
                                                   : std::ranges::max(part));
    }
    return result;
}

double excess_g(double envelope_g, double rest_g) {
    return std::sqrt(std::max(0.0, envelope_g * envelope_g - rest_g * rest_g));
}

// Cuts a run at the deepest place between two heights, and each part again.
void add_cut(std::span<const double> excess, Run run, std::vector<Run>& runs) {
    std::size_t valley = run.first;
    double deepest = kDeepValley;
    std::vector<double> behind(run.last - run.first + 2, 0.0);
    for (std::size_t k = run.last + 1; k-- > run.first;) {
        behind[k - run.first] = std::max(behind[k - run.first + 1], excess[k]);
    }
    double before = 0.0;
    for (std::size_t k = run.first; k <= run.last; ++k) {
        const double lower = std::min(before, behind[k - run.first + 1]);
        if (excess[k] < deepest * lower) {
            deepest = excess[k] / lower;
            valley = k;
        }
        before = std::max(before, excess[k]);
    }
    if (valley == run.first) return runs.push_back(run);
    add_cut(excess, {run.first, valley - 1}, runs);
    add_cut(excess, {valley, run.last}, runs);
}

std::vector<Run> runs_of(std::span<const double> envelope, std::span<const double> rest,
                         std::span<const double> excess) {
    const double least = kLeastShare * std::ranges::max(envelope);
    std::vector<Run> runs;
    for (std::size_t k = 0; k < excess.size(); ++k) {
        const auto stands_out = [&](std::size_t at) {
            const double energy = excess[at] * excess[at];
            return excess[at] > least && energy > kLeastExcess * rest[at] * rest[at];
        };
        if (!stands_out(k)) continue;
        const std::size_t first = k;
        while (k + 1 < excess.size() && stands_out(k + 1)) ++k;
        add_cut(excess, {first, k}, runs);
    }
    return runs;
}

// Down to the feet, or to the next one.
void widen(std::vector<Run>& runs, std::span<const double> excess) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
        Run& run = runs[r];
        const auto part = excess.subspan(run.first, run.last - run.first + 1);
        const double foot = kFoot * std::ranges::max(part);
        const std::size_t low = r == 0 ? 0 : runs[r - 1].last + 1;
        const std::size_t high = r + 1 == runs.size() ? excess.size() - 1 : runs[r + 1].first - 1;
        while (run.first > low && excess[run.first - 1] > foot) --run.first;
        while (run.last < high && excess[run.last + 1] > foot) ++run.last;
    }
}

std::vector<Run> without_tremors(const std::vector<Run>& runs, double step_s) {
    const auto middle_s = [step_s](const Run& run) {
        return 0.5 * step_s * static_cast<double>(run.first + run.last);
    };
    std::vector<Run> kept;
    for (std::size_t begin = 0; begin < runs.size();) {
        std::size_t end = begin + 1;
        while (end < runs.size() && middle_s(runs[end]) - middle_s(runs[end - 1]) < kLongestS) {
            ++end;
        }
        if (end - begin < kTremor) {
            const auto first = runs.begin() + static_cast<std::ptrdiff_t>(begin);
            kept.insert(kept.end(), first, runs.begin() + static_cast<std::ptrdiff_t>(end));
        }
        begin = end;
    }
    return kept;
}

// From the energy in the run beyond that of what is left: its sum, the mean and spread of its
// times.
ShortBurst burst_in(const Waveform& signal, std::span<const double> rest_g, const Run& run,
                    double step_s) {
    const std::vector<double>& x = signal.samples_g;
    const double begin_s = step_s * static_cast<double>(run.first);
    const double end_s = step_s * static_cast<double>(run.last);
    const std::size_t first = std::min(sample_count(begin_s, signal.rate_hz), x.size());
    const std::size_t end = std::min(sample_count(end_s, signal.rate_hz), x.size());
    double sum = 0.0;
    double first_moment = 0.0;
    double second_moment = 0.0;
    for (std::size_t n = first; n < end; ++n) {
        const double t_s = static_cast<double>(n) / signal.rate_hz - begin_s;
        const auto k =
            std::min(static_cast<std::size_t>((begin_s + t_s) / step_s), rest_g.size() - 1);
        const double energy = x[n] * x[n] - 0.5 * rest_g[k] * rest_g[k];
        sum += energy;
        first_moment += energy * t_s;
        second_moment += energy * t_s * t_s;
    }
    if (!(sum > 0.0)) return {};
    const double middle_s = std::clamp(first_moment / sum, 0.0, end_s - begin_s);
    const double variance = std::max(0.0, second_moment / sum - middle_s * middle_s);
    const double duration_s =
        std::clamp(std::sqrt(variance) / kWindowSpread, kShortestS, kLongestS);
    const double amplitude_g = std::sqrt(2.0 * sum / (signal.rate_hz * kWindowEnergy * duration_s));
    return {std::max(0.0, begin_s + middle_s - 0.5 * duration_s), duration_s, amplitude_g};
}

}  // namespace

BurstsFound short_bursts(const Waveform& signal, std::span<const double> envelope_g,
                         double step_s) {
    BurstsFound found{{}, {envelope_g.begin(), envelope_g.end()}};
    if (envelope_g.empty()) return found;
    const auto reach = static_cast<std::size_t>(std::lround(0.5 * (kLongestS + kWindowS) / step_s));
    const std::vector<double> lasting =
        moving(moving(envelope_g, reach, Extreme::least), reach, Extreme::largest);
    std::vector<double> excess;
    for (std::size_t k = 0; k < lasting.size(); ++k) {
        excess.push_back(excess_g(envelope_g[k], lasting[k]));
    }
    std::vector<Run> runs = runs_of(envelope_g, lasting, excess);
    widen(runs, excess);
    for (const Run& run : without_tremors(runs, step_s)) {
        const ShortBurst burst = burst_in(signal, lasting, run, step_s);
        if (!(burst.amplitude_g > 0.0)) continue;
        found.bursts.push_back(burst);
        for (std::size_t k = run.first; k <= run.last; ++k) found.rest_g[k] = lasting[k];
    }
    return found;
}

}  // namespace tact
