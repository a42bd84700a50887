#include "model/subset/widest_set.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/subset/clique.h"
#include "model/subset/subset_start.h"

namespace tact {

std::vector<std::size_t> far_from_kept(const WidestProblem& problem, Units least) {
    std::vector<std::size_t> far;
    for (const std::size_t v : problem.others) {
        const auto is_far = [&](std::size_t u) { return problem.distances(u, v) >= least; };
        if (std::ranges::all_of(problem.kept, is_far)) far.push_back(v);
    }
    return far;
}

WidestSet widest_set(const WidestProblem& problem, std::vector<std::size_t> start,
                     std::optional<Units> bound, const SearchLimit& limit, const WidestTold& told) {
    const std::vector<Units> values = distinct_values(problem.distances);
    const auto place_of = [&values](Units value) {
        return static_cast<std::size_t>(std::ranges::upper_bound(values, value) - values.begin()) -
               1;
    };
    WidestSet widest{std::move(start), 0, 0};
    widest.weakest = weakest_of(problem.distances, widest.members);
    // The kept ones stay as close as they are.
    const Units of_kept = weakest_of(problem.distances, problem.kept);
    std::size_t low = place_of(widest.weakest);
    std::size_t high = place_of(std::min({of_kept, values.back(), bound.value_or(of_kept)}));
    const double all = portable::log2(static_cast<double>(high - low + 2));
    widest.bound = std::max(widest.weakest, values[high]);
    if (told) told(0.0, widest);
    while (low < high) {
        const std::size_t middle = low + (high - low + 1) / 2;
        const Graph graph = graph_of(problem.distances, values[middle]);
        CliqueSearch found = find_clique(graph, far_from_kept(problem, values[middle]),
                                         problem.count - problem.kept.size(), limit);
        if (found.verdict == CliqueVerdict::unknown) break;
        if (found.verdict == CliqueVerdict::found) {
            widest.members = std::move(found.members);
            widest.members.insert(widest.members.end(), problem.kept.begin(), problem.kept.end());
            widest.weakest = weakest_of(problem.distances, widest.members);
            low = place_of(widest.weakest);
        } else {
            high = middle - 1;
        }
        const double left = portable::log2(static_cast<double>(high - std::min(low, high) + 2));
        const double share = all > 1.0 ? (all - left) / (all - 1.0) : 1.0;
        widest.bound = std::max(widest.weakest, values[high]);
        if (told) told(share, widest);
    }
    std::ranges::sort(widest.members);
    return widest;
}

}  // namespace tact
