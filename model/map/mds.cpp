#include "model/map/mds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

#include "model/common/decompositions.h"
#include "model/common/parallel.h"
#include "model/common/random.h"
#include "model/map/landmarks.h"
#include "model/map/principal_axes.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Eigen cuts large products into blocks that fit the caches of the processor it runs on, and
// another cut is another order of sums. These are of no processor; for the whole program, before it
// begins.
[[maybe_unused]] const bool kBlocksAreFixed = [] {
    Eigen::setCpuCacheSizes(kBlockCacheBytes[0], kBlockCacheBytes[1], kBlockCacheBytes[2]);
    return true;
}();

// Eigenvalues below this share of the largest are rounding noise.
constexpr double kVanished = 1e-12;

// Finite, not negative, at most 1, in the same order and proportion as far as they were not
// negative: squares then neither overflow nor turn the order. Unknown pairs get the mean.
std::vector<double> tame(std::span<const double> values, const PairOrder& order) {
    double least = 0.0;
    double most = 0.0;  // of halves, whose difference cannot overflow
    std::vector<double> result(values.begin(), values.end());
    const double known = order.ascending.empty() ? 0.0 : values[order.ascending.front()];
    for (const std::size_t p : order.unknown) result[p] = known;  // changes neither of the two
    for (const double value : result) least = std::min(least, value);
    for (const double value : result) most = std::max(most, value / 2 - least / 2);
    if (most == 0.0) return std::vector<double>(values.size(), 0.0);
    // In order of memory: of millions, the order of size takes several times as long.
    for (double& value : result) value = (value / 2 - least / 2) / most;
    if (order.unknown.empty()) return result;
    double mean = 0.0;
    for (const std::size_t p : order.ascending) {
        mean += result[p] / static_cast<double>(order.ascending.size());
    }
    for (const std::size_t p : order.unknown) result[p] = mean;
    return result;
}

// The largest known value above the least, or above 0 if none is negative.
double reach(std::span<const double> values, const PairOrder& order) {
    double least = 0.0;
    double most = 0.0;
    for (const std::size_t p : order.ascending) {
        least = std::min(least, values[p]);
        most = std::max(most, values[p]);
    }
    return most - least;
}

// B = -1/2 J Delta^2 J, the inner products that points with these distances would have.
MatrixXd inner_products(std::size_t n, std::span<const double> values) {
    const auto size = static_cast<Index>(n);
    MatrixXd b = MatrixXd::Zero(size, size);
    std::size_t p = 0;
    for (Index i = 0; i < size; ++i) {
        for (Index j = i + 1; j < size; ++j, ++p) b(i, j) = b(j, i) = -values[p] * values[p] / 2;
    }
    const Eigen::VectorXd row_mean = b.rowwise().mean();
    const double mean = row_mean.mean();
    b.colwise() -= row_mean;
    b.rowwise() -= row_mean.transpose();
    b.array() += mean;
    return b;
}

MatrixXd classical(std::size_t n, std::span<const double> values, int dimensions) {
    const Index k = std::max(dimensions, 1);
    MatrixXd points = MatrixXd::Zero(static_cast<Index>(n), k);
    if (n < 2) return points;
    const SymmetricEigen eigen = symmetric_eigen(inner_products(n, values));
    const Index last = points.rows() - 1;  // eigenvalues rise
    const double least = kVanished * eigen.values(last);
    for (Index c = 0; c < std::min(k, points.rows()); ++c) {
        const double value = eigen.values(last - c);
        if (value <= least) break;
        points.col(c) = std::sqrt(value) * eigen.vectors.col(last - c);
    }
    mirror_to_positive(points);
    return points;
}

// With n <= k + 1 there is room for any order: adding 2c to all squared dissimilarities keeps their
// order and adds c to every eigenvalue of B but that of the centre (Lingoes 1971). With the least c
// that leaves none negative, points with exactly these distances exist.
MatrixXd exact_map(std::size_t n, std::vector<double> values, int dimensions) {
    const double c = std::max(0.0, -symmetric_eigenvalues(inner_products(n, values))(0));
    for (double& value : values) value = std::sqrt(value * value + 2 * c);
    return classical(n, values, dimensions);
}

// For centred points, sum d^2 over pairs = n sum |x|^2.
MatrixXd framed(const MatrixXd& points) {
    MatrixXd result = on_principal_axes(points);
    const double n = static_cast<double>(points.rows());
    const double size = std::sqrt(2.0 * result.squaredNorm() / std::max(n - 1.0, 1.0));
    if (size > 0.0) result /= size;
    return result;
}

// The smallest distance of a pair although others are more alike; infinite without such a pair.
// Ascending order: the first level is the least.
double nearest_unlike(const PairOrder& order, std::span<const double> d) {
    const bool tied = !order.ties.empty() && order.ties.front().first == 0;
    const std::size_t least =
        std::min(tied ? order.ties.front().second : 1, order.ascending.size());
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = least; k < order.ascending.size(); ++k) {
        nearest = std::min(nearest, d[order.ascending[k]]);
    }
    return nearest;
}

bool colocated(const PairOrder& order, std::span<const double> d) {
    double farthest = 0.0;
    for (const double value : d) farthest = std::max(farthest, value);
    return nearest_unlike(order, d) < 1e-6 * farthest;
}

// Below this stress a map is examined for collapsed groups, and a distance below this share of the
// mean one is a collapse: descents stop before such points meet exactly.
constexpr double kSuspiciousStress = 1e-3;
constexpr double kCollapsedShare = 1e-3;

bool has_groups_on_spots(const PairOrder& order, std::span<const double> d) {
    const double mean = std::accumulate(d.begin(), d.end(), 0.0) / static_cast<double>(d.size());
    return nearest_unlike(order, d) < kCollapsedShare * mean;
}

bool is_of_few(const MatrixXd& points) { return points.rows() <= 2 * points.cols() + 1; }

bool degenerate(const PairOrder& order, std::span<const double> d, const PerceptualSpace& space) {
    if (space.verdict == MdsVerdict::colocated) return true;
    if (space.stress1 >= kSuspiciousStress || d.empty()) return false;
    return is_of_few(space.points) || has_groups_on_spots(order, d);
}

struct Task {
    const Dissimilarity& dissimilarity;
    PairOrder order;
    int dimensions;
    MdsVerdict verdict;
};

Task task_of(const Dissimilarity& dissimilarity, const MdsParams& params) {
    assert(dissimilarity.condensed.size() == pair_count(dissimilarity.size) && "one value a pair");
    const int k = std::max(params.dimensions, 1);
    Task task{dissimilarity, order_pairs(dissimilarity.condensed), k, MdsVerdict::fine};
    const std::size_t n = dissimilarity.size;
    // Two objects have one dissimilarity; it says something as long as it is not zero.
    const bool apart = n == 2 && reach(dissimilarity.condensed, task.order) > 0.0;
    if (n < 2) {
        task.verdict = MdsVerdict::too_few;
    } else if (task.order.levels < 2 && !apart) {
        task.verdict = MdsVerdict::constant;
    } else if (n <= static_cast<std::size_t>(k) + 1) {
        task.verdict = MdsVerdict::trivial;
    }
    return task;
}

PerceptualSpace space_of(const Task& task, const MatrixXd& points) {
    PerceptualSpace space;
    space.points = framed(points);
    const std::vector<double> d = distances(space.points);
    space.stress1 = stress1(d, disparities(task.dissimilarity.condensed, d));
    space.verdict = task.verdict;
    if (space.verdict == MdsVerdict::fine && colocated(task.order, d)) {
        space.verdict = MdsVerdict::colocated;
    }
    space.is_degenerate = degenerate(task.order, d, space);
    return space;
}

// Maps that need no descent.
PerceptualSpace space_at_once(const Task& task) {
    const std::size_t n = task.dissimilarity.size;
    if (task.verdict != MdsVerdict::trivial) {
        PerceptualSpace space;
        space.points = MatrixXd::Zero(static_cast<Index>(n), task.dimensions);
        space.verdict = task.verdict;
        space.is_degenerate = task.verdict == MdsVerdict::constant;
        return space;
    }
    const std::vector<double> values = tame(task.dissimilarity.condensed, task.order);
    PerceptualSpace space = space_of(task, exact_map(n, values, task.dimensions));
    space.start_stress = {space.stress1};
    return space;
}

MatrixXd torgerson_start(const Task& task) {
    return classical(task.dissimilarity.size, tame(task.dissimilarity.condensed, task.order),
                     task.dimensions);
}

// Torgerson's start of more objects takes longer than all descents, seconds for a thousand, and
// heeds no stop. Classical scaling by landmarks is as good to descend from.
constexpr std::size_t kMostForTorgerson = 300;

MatrixXd classical_start(const Task& task) {
    const std::size_t n = task.dissimilarity.size;
    if (n <= kMostForTorgerson) return torgerson_start(task);
    return landmark_scaling({n, tame(task.dissimilarity.condensed, task.order)}, task.dimensions);
}

// Most starts end in worse valleys, and most of a descent is its end. So all rest once their steps
// gain less than this, and the lowest few descend farther; what rests this far above has lost.
constexpr double kRestAt = 1e-6;
constexpr double kLostBy = 1e-4;
constexpr std::size_t kFinalists = 3;

DescentParams until_rest(DescentParams how) {
    how.rest_at = how.tolerance < kRestAt ? kRestAt : 0.0;
    return how;
}

struct Found {
    Descent best;
    std::vector<double> rested;  // stress of every start that was run
};

// The lowest descents that were run, at most kFinalists, by where they rest.
std::vector<std::size_t> finalists(std::span<const Descent> descents) {
    std::vector<std::size_t> lowest;
    for (std::size_t k = 0; k < descents.size(); ++k) {
        if (descents[k].points.size() > 0) lowest.push_back(k);
    }
    std::ranges::stable_sort(lowest, {}, [&](std::size_t k) { return descents[k].stress1; });
    if (lowest.size() > kFinalists) lowest.resize(kFinalists);
    std::erase_if(lowest, [&, least = descents[lowest.front()].stress1](std::size_t k) {
        return descents[k].stress1 > least + kLostBy;
    });
    std::ranges::sort(lowest);
    return lowest;
}

// Judged as far as the search has come: of very many objects the rest would keep a stop waiting.
PerceptualSpace stopped_space(const Task& task, const Found& found) {
    PerceptualSpace space;
    space.points = framed(found.best.points);
    space.stress1 = found.best.stress1;
    space.verdict = task.verdict;
    space.start_stress = found.rested;
    space.stopped = true;
    return space;
}

// `rested` is called for every start that comes to rest, never by two at once.
Found best_of_starts(const Task& task, int random_starts, const MdsParams& params,
                     const DescentParams& how, const std::stop_token& stop,
                     const std::function<void()>& rested) {
    const auto n = static_cast<Index>(task.dissimilarity.size);
    const DescentParams resting = until_rest(how);
    std::vector<Descent> descents(static_cast<std::size_t>(std::max(random_starts, 0)) + 1);
    std::mutex reporting;
    const auto run = [&](std::size_t index) {
        descents[index] = descend(task.order,
                                  index == 0 ? classical_start(task)
                                             : random_start(n, task.dimensions, params.seed, index),
                                  resting, stop);
        const std::lock_guard lock(reporting);
        if (rested) rested();
    };
    parallel_for(descents.size(), params.threads, stop, run);
    // Stopped before anything was done: Torgerson's start is still a map.
    if (descents[0].points.size() == 0) run(0);

    Found found;
    for (const Descent& descent : descents) {
        if (descent.points.size() > 0) found.rested.push_back(descent.stress1);
    }
    const std::vector<std::size_t> few = finalists(descents);
    parallel_for(few.size(), params.threads, stop, [&](std::size_t k) {
        Descent& descent = descents[few[k]];
        if (descent.rests) descent = continued(task.order, descent, how, stop);
    });
    const auto best = std::ranges::min_element(
        few, {}, [&](std::size_t k) { return descents[k].stress1; });  // of equals the first
    found.best = std::move(descents[*best]);
    return found;
}

// The best map by interval scaling, from the starts of a search; `collapsed` is what ordinal
// scaling found, and stays where groups collapse in this as well.
PerceptualSpace by_interval_scaling(const Task& task, PerceptualSpace collapsed,
                                    const MdsParams& params, const std::stop_token& stop) {
    constexpr int kStarts = 20;  // metric scaling has few local minima
    const std::vector<double> values = tame(task.dissimilarity.condensed, task.order);
    const DescentParams how{params.tolerance, params.max_steps, values};
    const int starts = std::min(params.random_starts, kStarts);
    if (stop.stop_requested()) return collapsed;
    const Found found = best_of_starts(task, starts, params, how, stop, {});
    PerceptualSpace space = space_of(task, found.best.points);
    if (has_groups_on_spots(task.order, distances(space.points))) return collapsed;
    space.is_interval = true;
    space.collapsed_stress1 = collapsed.stress1;
    return space;
}

// The share of each point in the squared misfit of its map.
std::vector<double> misfits(const Task& task, const MatrixXd& points) {
    const std::vector<double> d = distances(points);
    const std::vector<double> fitted = disparities(task.dissimilarity.condensed, d);
    const auto n = task.dissimilarity.size;
    std::vector<double> misfit(n, 0.0);
    std::size_t p = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j, ++p) {
            if (std::isnan(task.dissimilarity.condensed[p])) continue;
            const double square = (d[p] - fitted[p]) * (d[p] - fitted[p]);
            misfit[i] += square;
            misfit[j] += square;
        }
    }
    return misfit;
}

// A point in the wrong place is kept there by the others. So the worst ones, one by one, are put on
// the other side of the centre, and all descend again from there. Whatever ends lower is kept, and
// its own worst point is next. Where data have no structure this finds what more starts do not;
// where they have, nothing is lower.
Descent with_points_turned(const Task& task, Descent best, const MdsParams& params,
                           const std::stop_token& stop) {
    constexpr std::size_t kMisses = 10;  // in a row
    constexpr double kLower = 1e-9;
    const DescentParams how{params.tolerance, params.max_steps};
    std::size_t misses = 0;
    std::vector<std::size_t> worst;
    for (int turn = 0; turn < params.turned_points && !stop.stop_requested(); ++turn) {
        if (misses == 0) {
            const std::vector<double> misfit = misfits(task, best.points);
            worst.resize(misfit.size());
            std::iota(worst.begin(), worst.end(), std::size_t{0});
            std::ranges::stable_sort(worst, std::greater{},
                                     [&](std::size_t k) { return misfit[k]; });
        }
        if (misses == std::min(kMisses, worst.size())) break;
        MatrixXd start = best.points.rowwise() - best.points.colwise().mean();
        start.row(static_cast<Index>(worst[misses])) *= -1.0;
        Descent turned = descend(task.order, start, until_rest(how), stop);
        ++misses;
        if (turned.stress1 >= best.stress1 + kLostBy) continue;
        if (turned.rests) turned = continued(task.order, turned, how, stop);
        if (turned.stress1 >= best.stress1 - kLower) continue;
        best = std::move(turned);
        misses = 0;
    }
    return best;
}

bool usable(const MatrixXd& start, const Task& task) {
    return start.rows() == static_cast<Index>(task.dissimilarity.size) &&
           start.cols() == task.dimensions && start.allFinite() &&
           (start.rowwise() - start.row(0)).norm() > 0.0;
}

}  // namespace

MatrixXd torgerson(const Dissimilarity& dissimilarity, int dimensions) {
    const PairOrder order = order_pairs(dissimilarity.condensed);
    // Scaled to at most 1 within, so that no square overflows.
    const double unit = reach(dissimilarity.condensed, order);
    return unit * classical(dissimilarity.size, tame(dissimilarity.condensed, order), dimensions);
}

// Not Gaussian, which takes longer: after a few steps no difference is left.
MatrixXd random_start(Index n, Index k, std::uint64_t seed, std::size_t index) {
    RandomStream random{random_bits(seed, index)};
    MatrixXd points(n, k);
    for (Index e = 0; e < points.size(); ++e) points.data()[e] = next_even(random);
    return points;
}

PerceptualSpace smacof(const Dissimilarity& dissimilarity, const MatrixXd& start,
                       const MdsParams& params, std::stop_token stop) {
    const Task task = task_of(dissimilarity, params);
    if (task.verdict != MdsVerdict::fine) return space_at_once(task);
    const MatrixXd& first = usable(start, task) ? start : classical_start(task);
    DescentParams how{params.tolerance, params.max_steps};
    std::vector<double> values;
    if (params.is_interval) values = tame(dissimilarity.condensed, task.order);
    how.interval_of = values;
    const Descent descent = descend(task.order, first, how, stop);
    PerceptualSpace space = space_of(task, descent.points);
    space.is_interval = params.is_interval;
    space.start_stress = {space.stress1};
    space.stopped = stop.stop_requested();
    return space;
}

PerceptualSpace nonmetric_mds(const Dissimilarity& dissimilarity, const MdsParams& params,
                              std::stop_token stop,
                              const std::function<void(std::size_t)>& progress,
                              const std::function<void(const MatrixXd&)>& lower) {
    const Task task = task_of(dissimilarity, params);
    if (task.verdict != MdsVerdict::fine) return space_at_once(task);
    std::mutex watching;
    double least = std::numeric_limits<double>::infinity();
    const std::function watch = [&](const MatrixXd& points, double stress1) {
        const std::lock_guard lock(watching);
        if (stress1 >= least || stop.stop_requested()) return;
        least = stress1;
        lower(points);
    };
    DescentParams how{params.tolerance, params.max_steps};
    if (lower) how.watch = &watch;
    std::size_t finished = 0;
    const auto tell = [&] {
        if (progress) progress(++finished);
    };
    Found found = best_of_starts(task, params.random_starts, params, how, stop, tell);
    if (stop.stop_requested()) return stopped_space(task, found);
    const Descent settled = with_points_turned(task, std::move(found.best), params, stop);
    PerceptualSpace space = space_of(task, settled.points);
    if (space.is_degenerate && has_groups_on_spots(task.order, distances(space.points))) {
        space = by_interval_scaling(task, std::move(space), params, stop);
    }
    space.start_stress = std::move(found.rested);
    space.stopped = stop.stop_requested();
    return space;
}

namespace {

constexpr const char* kInstead = "read the matrix instead, or map in two dimensions";

// Points that are no collapse away from one before them: the mean squared distance is 1.
std::size_t spots(const MatrixXd& points) {
    std::size_t count = 0;
    for (Index i = 0; i < points.rows(); ++i) {
        bool is_first = true;
        for (Index j = 0; j < i; ++j) {
            is_first = is_first && (points.row(i) - points.row(j)).norm() >= kCollapsedShare;
        }
        if (is_first) ++count;
    }
    return count;
}

std::string collapsed_text(const std::string& what) {
    std::string text = "degenerate: ";
    text += what;
    text += ", which meets the order of the dissimilarities without showing it; ";
    return text += kInstead;
}

}  // namespace

std::string remark_on(const PerceptualSpace& space) {
    switch (space.verdict) {
        case MdsVerdict::trivial:
            return std::to_string(space.points.rows()) + " patterns always fit in " +
                   std::to_string(space.points.cols()) + " dimensions: stress says nothing";
        case MdsVerdict::constant:
            return "all dissimilarities are equal: no map is better than another, all points are "
                   "put at 0";
        case MdsVerdict::colocated:
            return collapsed_text(std::to_string(space.points.rows()) + " patterns lie on " +
                                  std::to_string(spots(space.points)) + " spots");
        case MdsVerdict::too_few:
        case MdsVerdict::fine:
            break;
    }
    if (space.is_interval) {
        const std::string stress =
            std::isnan(space.collapsed_stress1)
                ? ""
                : " (stress-1 " + fixed_digits(space.collapsed_stress1, 3) + ")";
        return std::string("groups of patterns collapse in the best map by order") + stress +
               ", which meets the order without showing it: this map is of interval scaling, by "
               "the size of the dissimilarities";
    }
    if (!space.is_degenerate) return {};
    if (space.points.rows() > 2 * space.points.cols() + 1) {
        return collapsed_text("groups of patterns have collapsed");
    }
    std::string text = "degenerate: nearly any dissimilarities of ";
    text += std::to_string(space.points.rows()) + " patterns fit in ";
    text += std::to_string(space.points.cols()) + " dimensions, so stress says nothing; ";
    return text += kInstead;
}

std::string fit_label(const PerceptualSpace& space) {
    return space.is_degenerate ? "degenerate" : stress_label(space.stress1);
}

MdsParams published_mds_params(int dimensions) {
    MdsParams params;
    params.dimensions = dimensions;
    params.random_starts = 0;
    params.tolerance = 1e-4;
    params.max_steps = 200;
    return params;
}

MdsParams standard_mds_params(std::size_t objects, int dimensions) {
    MdsParams params;
    params.dimensions = dimensions;
    if (objects <= 100) params.turned_points = 20;
    if (objects > 30) params.random_starts = 30;
    if (objects > 100) params.random_starts = 10;
    if (objects > 300) params.random_starts = 3;
    if (objects > 1000) params.random_starts = 0;
    if (objects > 300) params.tolerance = 1e-7;
    return params;
}

}  // namespace tact
