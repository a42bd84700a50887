#include "model/ask/reach.h"

#include <algorithm>
#include <cmath>

#include "model/ask/vary.h"
#include "model/common/parallel.h"

namespace tact {

namespace {

constexpr std::size_t kWide = 64;
constexpr std::size_t kClose = 24;
constexpr int kRounds = 7;
constexpr double kFirstRadius = 10.0;  // felt steps

struct Best {
    Pattern pattern;
    Eigen::RowVectorXd at;
    double off = 0.0;
};

// Ties: the first. False when stopped.
bool improve(Best& best, const std::vector<Pattern>& tried, const ReachQuestion& question,
             const MovedPoint& map, const ReachOptions& options) {
    std::vector<Eigen::RowVectorXd> places(tried.size());
    const bool all = parallel_for(tried.size(), options.threads, options.stop, [&](std::size_t k) {
        Waveform waveform = render(tried[k]);
        if (options.felt) waveform = options.felt(waveform);
        const auto place = map(waveform, options.stop, 1);
        if (place) places[k] = place->at;
    });
    if (!all || options.stop.stop_requested()) return false;
    for (std::size_t k = 0; k < tried.size(); ++k) {
        const double off = (places[k] - question.target).norm();
        if (off < best.off) best = {tried[k], places[k], off};
    }
    return true;
}

constexpr double kGrainOfStep = 0.1;

// The coarsest of 1, 2 and 5 times a power of ten that is no more than a part of a felt step.
double grain_at(const FeltSteps& steps, PatternParameter parameter, double value) {
    const double most = kGrainOfStep * std::abs(stepped(steps, parameter, value, 1.0) -
                                                stepped(steps, parameter, value, 0.0));
    if (!(most > 0.0)) return 0.0;  // at the end of its range
    const double ten = std::pow(10.0, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0}) {
        if (times * ten <= most) return times * ten;
    }
    return ten;
}

// What is found is to be read and typed: 63 Hz, not 63.278 Hz.
std::vector<Pattern> rounded(std::vector<Pattern> patterns,
                             const std::vector<PatternParameter>& numbers,
                             const ReachQuestion& question) {
    for (Pattern& pattern : patterns) {
        for (const PatternParameter number : numbers) {
            const double value = *value_of(pattern, number);
            const double grain = grain_at(question.steps, number, value);
            if (grain == 0.0 || value == *value_of(question.pattern, number)) continue;
            // Division by a whole number of grains gives the decimal that is nearest.
            const double grains = std::round(value / grain);
            pattern = with_value(pattern, number,
                                 grain < 1.0 ? grains / std::round(1.0 / grain) : grains * grain);
        }
    }
    return patterns;
}

// PM of a distance of one in the map, by all pairs: the line through 0 with the least squares.
double pm_of_one(const MovedPoint& map) {
    double products = 0.0;
    double squares = 0.0;
    for (Eigen::Index i = 0; i < map.points().rows(); ++i) {
        for (Eigen::Index j = i + 1; j < map.points().rows(); ++j) {
            const double distance = (map.points().row(i) - map.points().row(j)).norm();
            products +=
                distance * map.pm()(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
            squares += distance * distance;
        }
    }
    return squares > 0.0 ? products / squares : 0.0;
}

}  // namespace

bool is_reached(const Reached& reached) {
    return reached.off_pm <= kReachedWithin * reached.largest_pm;
}

std::vector<Pattern> surroundings(const Pattern& pattern, const std::vector<PatternParameter>& free,
                                  const FeltSteps& steps, std::size_t count, std::uint64_t seed) {
    const auto numbers = free_numbers(pattern, free);
    std::vector<Pattern> all{pattern};
    RandomStream random{seed};
    while (all.size() < count && !numbers.empty()) {
        const double share = static_cast<double>(all.size()) / static_cast<double>(count);
        all.push_back(
            stepped_at_random(pattern, numbers, steps, 1.0 + 29.0 * share * share, random));
    }
    return all;
}

std::optional<Reached> reach(const ReachQuestion& question, const MovedPoint& map,
                             const ReachOptions& options) {
    Best best{question.pattern, {}, HUGE_VAL};
    const auto numbers = free_numbers(question.pattern, question.free);
    RandomStream random{question.seed + 1};
    const auto wide =
        surroundings(question.pattern, question.free, question.steps, kWide, question.seed);
    if (!improve(best, rounded(wide, numbers, question), question, map, options)) {
        return std::nullopt;
    }
    double radius = kFirstRadius;
    for (int round = 0; round < kRounds && !numbers.empty(); ++round, radius *= 0.55) {
        if (options.progress) options.progress((1.0 + round) / (1.0 + kRounds));
        std::vector<Pattern> near;
        for (std::size_t k = 0; k < kClose; ++k) {
            near.push_back(
                stepped_at_random(best.pattern, numbers, question.steps, radius, random));
        }
        near = rounded(std::move(near), numbers, question);
        if (!improve(best, near, question, map, options)) return std::nullopt;
    }
    if (options.progress) options.progress(1.0);
    const auto& pm = map.pm().condensed;
    return Reached{best.pattern, best.at, best.off, best.off * pm_of_one(map),
                   pm.empty() ? 0.0 : *std::ranges::max_element(pm)};
}

}  // namespace tact
