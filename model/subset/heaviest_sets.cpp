#include "model/subset/heaviest_sets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "model/common/parallel.h"
#include "model/subset/concave_bound.h"

namespace tact {

namespace {

// When only this share of the candidates is left, the shift is computed again, unless too few are
// still to be chosen for it to be worth it.
constexpr double kRenewAt = 0.75;
constexpr std::size_t kRenewFor = 4;

// The shift of more objects than this takes longer than a limit may be passed by.
constexpr std::size_t kQuickShift = 700;

// Half of what the k objects with the farthest companions have to their k - 1 farthest ones: no set
// of k has more, whatever it is.
Units bound_of_farthest(const HeaviestProblem& problem) {
    std::vector<std::size_t> all(problem.kept.begin(), problem.kept.end());
    all.insert(all.end(), problem.others.begin(), problem.others.end());
    const std::size_t k = std::min(problem.count, all.size());
    if (k < 2) return 0;
    const auto sum_of_largest = [](std::vector<Units>& values, std::size_t count) {
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
        std::ranges::nth_element(values, end, std::greater<>{});
        return std::accumulate(values.begin(), end, Units{0});
    };
    std::vector<Units> reach;
    std::vector<Units> row;
    for (const std::size_t u : all) {
        row.clear();
        for (const std::size_t v : all) {
            if (u != v) row.push_back(problem.distances(u, v));
        }
        row.push_back(std::numeric_limits<Units>::min());  // a place to part at
        reach.push_back(sum_of_largest(row, k - 1));
    }
    reach.push_back(std::numeric_limits<Units>::min());
    return (sum_of_largest(reach, k) + 1) / 2;
}

// One set under construction and what it may still take.
struct Node {
    std::vector<std::size_t> chosen;
    Relaxation rest;
};

struct Branch {
    Node node;
    Units bound = 0;  // of the sets from it and from all later branches
};

class HeaviestSearch {
  public:
    HeaviestSearch(const HeaviestProblem& problem, BestSets& best, const SearchLimit& limit)
        : problem_(problem),
          best_(best),
          limit_(limit),
          distances_(problem.real),
          divisor_(problem.distances.divisor) {}

    // Whether the shift of that number of objects is there before the limit.
    bool has_time_for_shift(std::size_t objects) const {
        return objects <= kQuickShift || !limit_.is_by_clock() ||
               shift_seconds(objects) < limit_.left_s();
    }

    // Works a node off, and gives each of its branches to `take`. Gives the bound of what is left
    // when the limit is reached, otherwise nothing.
    template <class Take>
    std::optional<Units> work_off(Node& node, const Take& take) const {
        for (;;) {
            const std::optional<Units> bound = settled(node);
            if (!bound) return std::nullopt;
            if (limit_.reached()) return bound;
            // Largest share first: it is the likeliest to belong to the best set.
            std::size_t place = 0;
            for (std::size_t u = 1; u < node.rest.objects.size(); ++u) {
                if (comes_first(node.rest, u, place)) place = u;
            }
            Branch branch{node, *bound};
            take_into(branch.node, place);
            if (!take(std::move(branch))) return bound;
            leave_out(node.rest, distances_, place);
        }
    }

    // Called of each node that is explored, but not more often than a person can read.
    void every_node(std::function<void()> call) { call_ = std::move(call); }

    // False: the limit was reached.
    bool explore(Node& node) const {
        if (limit_.reached()) return false;
        if (call_ && is_due()) call_();
        return !work_off(node, [this](Branch branch) { return explore(branch.node); });
    }

    Node root() const {
        std::vector<std::size_t> fitting;
        for (const std::size_t v : problem_.others) {
            const auto fits = [&](std::size_t u) { return may_join(u, v); };
            if (std::ranges::all_of(problem_.kept, fits)) fitting.push_back(v);
        }
        return {{problem_.kept.begin(), problem_.kept.end()},
                relaxed(distances_, problem_.kept, fitting)};
    }

  private:
    bool is_due() const {
        constexpr std::int64_t kEveryMs = 50;
        const std::int64_t now = std::chrono::duration_cast<std::chrono::milliseconds>(
                                     std::chrono::steady_clock::now().time_since_epoch())
                                     .count();
        std::int64_t last = last_call_ms_;
        return now - last >= kEveryMs && last_call_ms_.compare_exchange_strong(last, now);
    }

    bool may_join(std::size_t a, std::size_t b) const {
        return problem_.graph == nullptr || problem_.graph->has(a, b);
    }

    static bool comes_first(const Relaxation& rest, std::size_t a, std::size_t b) {
        if (rest.share[a] != rest.share[b]) return rest.share[a] > rest.share[b];
        if (rest.slope[a] != rest.slope[b]) return rest.slope[a] > rest.slope[b];
        return rest.objects[a] < rest.objects[b];
    }

    void take_into(Node& node, std::size_t place) const {
        const std::size_t object = node.rest.objects[place];
        node.chosen.push_back(object);
        choose(node.rest, distances_, place);
        if (problem_.graph == nullptr) return;
        for (std::size_t u = node.rest.objects.size(); u > 0; --u) {
            if (may_join(object, node.rest.objects[u - 1])) continue;
            leave_out(node.rest, distances_, u - 1);
        }
    }

    // Takes and leaves all that must be; the bound of the sets from here on, if any may be kept.
    std::optional<Units> settled(Node& node) const {
        for (;;) {
            // Two that must be taken may be unable to stand together: then there are too many.
            if (node.chosen.size() > problem_.count) return std::nullopt;
            const std::size_t r = problem_.count - node.chosen.size();
            const std::size_t m = node.rest.objects.size();
            if (m < r) return std::nullopt;
            if (m == r && r > 1) {
                take_into(node, 0);
                continue;
            }
            if (r <= 1) {
                offer_all(node, r);
                return std::nullopt;
            }
            if (static_cast<double>(m) <= kRenewAt * static_cast<double>(node.rest.shift_of) &&
                r >= kRenewFor && has_time_for_shift(m)) {
                renew_shift(node.rest, distances_);
            }
            const auto floor = static_cast<double>(best_.floor());
            TangentBound tangent = tighten(node.rest, distances_, r, floor - 1.0);
            if (whole(tangent.bound) < best_.floor()) return std::nullopt;
            bool again = false;
            if (problem_.graph == nullptr) {
                again = settle(node, tangent);
            } else {
                const std::optional<bool> settled = settle_by_colour(node, tangent, r);
                if (!settled) return std::nullopt;
                again = *settled;
            }
            const Units bound = whole(tangent.bound);
            if (!may_be_kept(node, bound)) return std::nullopt;
            if (!again) return bound;
        }
    }

    // The largest sum there can be below a bound.
    Units whole(double bound) const {
        const double steps = std::floor((bound + slack_of(bound)) / static_cast<double>(divisor_));
        return static_cast<Units>(steps) * divisor_;
    }

    // Takes or leaves for good what the tangent decides; whether the bound should be sought again.
    bool settle(Node& node, const TangentBound& tangent) const {
        const std::size_t before = node.rest.objects.size();
        const Units floor = best_.floor();
        std::vector<std::size_t> taken;
        std::vector<std::size_t> left;
        for (std::size_t u = 0; u < before; ++u) {
            const double slope = node.rest.slope[u];
            const double without = tangent.bound - slope + tangent.next_slope;
            const double with = tangent.bound - tangent.last_slope + slope;
            if (slope < tangent.last_slope && whole(with) < floor) {
                left.push_back(node.rest.objects[u]);
            } else if (slope > tangent.next_slope && whole(without) < floor) {
                taken.push_back(node.rest.objects[u]);
            }
        }
        for (const std::size_t object : left) leave(node, object);
        for (const std::size_t object : taken) take_into(node, place_of(node, object));
        return !taken.empty() || 10 * node.rest.objects.size() <= 9 * before;
    }

    // A clique has one object of a colour, so its tangent has no more than the largest slope of
    // each of r colours. Leaves what cannot be in one; none if nothing can.
    std::optional<bool> settle_by_colour(Node& node, TangentBound& tangent, std::size_t r) const {
        Relaxation& rest = node.rest;
        const std::size_t before = rest.objects.size();
        std::vector<std::size_t> order(before);
        std::iota(order.begin(), order.end(), std::size_t{0});
        // Steep ones first: few colours then have large slopes.
        std::ranges::sort(order, [&rest](std::size_t a, std::size_t b) {
            return rest.slope[a] != rest.slope[b] ? rest.slope[a] > rest.slope[b]
                                                  : rest.objects[a] < rest.objects[b];
        });
        std::vector<std::size_t> objects;
        for (const std::size_t u : order) objects.push_back(rest.objects[u]);
        const std::vector<std::size_t> colours = greedy_colours(*problem_.graph, objects);
        // Colours are begun by their steepest, in falling order.
        std::vector<double> steepest;
        for (std::size_t k = 0; k < order.size(); ++k) {
            if (colours[k] == steepest.size()) steepest.push_back(rest.slope[order[k]]);
        }
        if (steepest.size() < r) return std::nullopt;
        double bound = tangent.bound;
        std::vector<double> slopes = rest.slope;
        std::ranges::sort(slopes, std::greater<>{});
        for (std::size_t k = 0; k < r; ++k) bound += steepest[k] - slopes[k];
        tangent.bound = bound;
        if (whole(bound) < best_.floor()) return std::nullopt;
        const std::vector<double> slope_before = rest.slope;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const double instead_of = steepest[std::min(colours[k], r - 1)];
            if (whole(bound - instead_of + slope_before[order[k]]) < best_.floor()) {
                leave(node, objects[k]);
            }
        }
        return 10 * rest.objects.size() <= 9 * before;
    }

    static std::size_t place_of(const Node& node, std::size_t object) {
        return static_cast<std::size_t>(std::ranges::find(node.rest.objects, object) -
                                        node.rest.objects.begin());
    }

    void leave(Node& node, std::size_t object) const {
        leave_out(node.rest, distances_, place_of(node, object));
    }

    // Where the bound is no more than the worst sum kept, only lower indices would help.
    bool may_be_kept(const Node& node, Units bound) const {
        const std::size_t missing = problem_.count - std::min(problem_.count, node.chosen.size());
        if (node.rest.objects.size() < missing) return false;
        if (bound > best_.floor()) return true;
        std::vector<std::size_t> lowest = node.rest.objects;
        std::ranges::sort(lowest);
        lowest.resize(missing);
        lowest.insert(lowest.end(), node.chosen.begin(), node.chosen.end());
        std::ranges::sort(lowest);
        return best_.would_keep(bound, lowest);
    }

    void offer_all(const Node& node, std::size_t r) const {
        if (r == 0) return best_.offer(heavy_set(problem_.distances, node.chosen));
        for (std::size_t u = 0; u < node.rest.objects.size(); ++u) {
            const double sum = node.rest.chosen_sum + node.rest.linear[u];
            if (sum + slack_of(sum) < static_cast<double>(best_.floor())) continue;
            std::vector<std::size_t> members = node.chosen;
            members.push_back(node.rest.objects[u]);
            best_.offer(heavy_set(problem_.distances, std::move(members)));
        }
    }

    const HeaviestProblem& problem_;
    BestSets& best_;
    const SearchLimit& limit_;
    const Eigen::MatrixXd& distances_;
    Units divisor_;
    std::function<void()> call_{};
    mutable std::atomic<std::int64_t> last_call_ms_ = 0;
};

}  // namespace

bool is_better(const HeavySet& a, const HeavySet& b) {
    return a.sum != b.sum ? a.sum > b.sum : a.members < b.members;
}

HeavySet heavy_set(const WholeDistances& distances, std::vector<std::size_t> members) {
    std::ranges::sort(members);
    HeavySet set{0, std::move(members)};
    for (const std::size_t i : set.members) {
        for (const std::size_t j : set.members) set.sum += i < j ? distances(i, j) : 0;
    }
    return set;
}

void BestSets::offer(const HeavySet& set) {
    const std::scoped_lock lock(mutex_);
    const auto place = std::ranges::lower_bound(sets_, set, is_better);
    if (place != sets_.end() && *place == set) return;
    sets_.insert(place, set);
    if (sets_.size() > capacity_) sets_.pop_back();
    if (sets_.size() == capacity_) floor_ = sets_.back().sum;
}

std::vector<HeavySet> BestSets::sets() const {
    const std::scoped_lock lock(mutex_);
    return sets_;
}

bool BestSets::would_keep(Units sum, std::span<const std::size_t> lowest) const {
    const std::scoped_lock lock(mutex_);
    if (sets_.size() < capacity_) return true;
    return is_better({sum, {lowest.begin(), lowest.end()}}, sets_.back());
}

HeaviestRun find_heaviest(const HeaviestProblem& problem, BestSets& best, const SearchLimit& limit,
                          int threads, const HeaviestTold& told) {
    assert(problem.kept.size() <= problem.count && "more to keep than to choose");
    HeaviestSearch search(problem, best, limit);
    if (!search.has_time_for_shift(problem.others.size())) {
        return {false, bound_of_farthest(problem)};
    }
    Units known = std::numeric_limits<Units>::max();
    if (told) {
        known = bound_of_farthest(problem);
        told(0.0, std::max(best.floor(), known));
    }
    Node root = search.root();
    // The branches of the root are the tasks; each continues from what the others have found.
    std::vector<Branch> tasks;
    const std::optional<Units> left = search.work_off(root, [&tasks](Branch branch) {
        tasks.push_back(std::move(branch));
        return true;
    });
    std::vector<std::atomic<bool>> is_done(tasks.size());
    std::atomic<std::size_t> done = 0;
    const auto bound_of_rest = [&] {
        Units bound = left.value_or(std::numeric_limits<Units>::min());
        for (std::size_t k = 0; k < tasks.size(); ++k) {
            if (!is_done[k]) bound = std::max(bound, tasks[k].bound);
        }
        return std::max(best.floor(), std::min(bound, known));
    };
    if (told) {
        search.every_node([&] {
            const auto share = static_cast<double>(done) / static_cast<double>(tasks.size());
            told(share, bound_of_rest());
        });
    }
    parallel_for(tasks.size(), threads, {}, [&](std::size_t k) {
        is_done[k] = search.explore(tasks[k].node);
        ++done;
    });
    HeaviestRun run;
    if (left) run = {false, *left};
    for (std::size_t k = 0; k < tasks.size(); ++k) {
        if (is_done[k]) continue;
        run.bound = run.is_complete ? tasks[k].bound : std::max(run.bound, tasks[k].bound);
        run.is_complete = false;
    }
    run.bound = std::min(run.bound, known);
    return run;
}

}  // namespace tact
