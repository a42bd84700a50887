// The pattern whose point comes nearest to a place of the map: put it there.
//
// Random changes of the numbers that are free, wide at first, then closer and closer around the
// best. Numbers are rounded to about a tenth of a felt step. What it cannot reach it says, with how
// far it stays off.
//
// Source    ours: random search with a shrinking radius
// Left out  rhythms' notes and what is drawn; other minima of the map
// Exact     same question, same answer, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/ask/moved_point.h"
#include "model/pattern/felt_steps.h"

namespace tact {

struct ReachQuestion {
    Pattern pattern;
    Eigen::RowVectorXd target;             // a place of the map
    std::vector<PatternParameter> free{};  // empty: all that the pattern has
    FeltSteps steps{};
    std::uint64_t seed = 1;
};

struct ReachOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};           // 0..1, from this thread
    std::function<Waveform(const Waveform&)> felt{};  // where a device plays it; none: itself
};

struct Reached {
    Pattern pattern;
    Eigen::RowVectorXd at;
    double off = 0.0;     // from the target, in the map's unit
    double off_pm = 0.0;  // the same as PM, by how the map's distances follow PM on average
    double largest_pm = 0.0;
};

// Within this share of the set's largest PM a place counts as reached.
inline constexpr double kReachedWithin = 0.05;
bool is_reached(const Reached& reached);

// How many patterns are tried.
inline constexpr std::size_t kReachTries = 64 + 7 * 24;

// None when stopped.
std::optional<Reached> reach(const ReachQuestion& question, const MovedPoint& map,
                             const ReachOptions& options);

// Patterns all around, near and far: where they come is what can be reached.
std::vector<Pattern> surroundings(const Pattern& pattern, const std::vector<PatternParameter>& free,
                                  const FeltSteps& steps, std::size_t count, std::uint64_t seed);

}  // namespace tact
