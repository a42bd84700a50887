#include "model/subset/subset.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "model/subset/clique.h"
#include "model/subset/heaviest_sets.h"
#include "model/subset/widest_set.h"

namespace tact {

namespace {

// So few tied pairs are each the start of a search of their own.
constexpr std::size_t kMostTies = 4096;

using Indices = std::vector<std::size_t>;

struct Picking {
    WholeDistances distances;
    Eigen::MatrixXd real;
    SubsetProblem problem;
    Indices kept;
    Indices others;
    SearchLimit limit;
    int threads = 0;

    WidestProblem widest() const { return {distances, problem.count, kept, others}; }
    HeaviestProblem heaviest() const {
        return {distances, real, nullptr, problem.count, kept, others};
    }
};

Picking picking_of(const Dissimilarity& dissimilarity, const SubsetProblem& problem,
                   const SubsetOptions& options) {
    // What is made ready counts as well.
    const SearchLimit limit = limit_of(options.time_limit_s, options.stop);
    Picking picking{
        whole_distances(dissimilarity), {}, problem, problem.keep, {}, limit, options.threads};
    picking.real = real_distances(picking.distances);
    std::ranges::sort(picking.kept);
    picking.kept.erase(std::unique(picking.kept.begin(), picking.kept.end()), picking.kept.end());
    for (std::size_t v = 0; v < dissimilarity.size; ++v) {
        const bool is_dropped = std::ranges::find(problem.drop, v) != problem.drop.end();
        const bool is_kept = std::ranges::binary_search(picking.kept, v);
        if (!is_dropped && !is_kept) picking.others.push_back(v);
    }
    return picking;
}

// What is done of the work or of the time, whichever is more: at the limit it ends in any case.
void tell_share(const Picking& picking, const SubsetOptions& options, double share) {
    if (!options.progress) return;
    const double of_time = picking.limit.is_by_clock() && options.time_limit_s > 0.0
                               ? 1.0 - picking.limit.left_s() / options.time_limit_s
                               : 0.0;
    options.progress(std::clamp(std::max(share, of_time), 0.0, 1.0));
}

// `pairs`: how many of them the bound is of.
void tell_so_far(const Picking& picking, const Dissimilarity& dissimilarity,
                 const SubsetOptions& options, const Indices& members, Units bound,
                 std::size_t pairs) {
    if (!options.so_far) return;
    SubsetAnswer answer;
    answer.best = subset_of(dissimilarity, members);
    answer.bound = std::max(largest_meant(picking.distances, bound, pairs),
                            worth_of(answer.best, picking.problem.objective));
    options.so_far(answer);
}

// Every exchange of one member that leaves all pairs so far apart: a floor for the search.
void offer_exchanges(const Picking& picking, const Indices& members, Units least, BestSets& best) {
    for (std::size_t m = 0; m < members.size(); ++m) {
        if (std::ranges::binary_search(picking.kept, members[m])) continue;
        for (const std::size_t v : picking.others) {
            Indices exchanged = members;
            exchanged[m] = v;
            const auto is_near = [&](std::size_t u) {
                return u != members[m] && (u == v || picking.distances(u, v) < least);
            };
            if (std::ranges::none_of(members, is_near)) {
                best.offer(heavy_set(picking.distances, exchanged));
            }
        }
    }
}

// The pairs that are exactly so far apart and may be picked both.
std::vector<std::pair<std::size_t, std::size_t>> pairs_at(const Picking& picking, Units value) {
    Indices all = picking.kept;
    all.insert(all.end(), picking.others.begin(), picking.others.end());
    std::ranges::sort(all);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const std::size_t i : all) {
        for (const std::size_t j : all) {
            if (i < j && picking.distances(i, j) == value) pairs.emplace_back(i, j);
        }
    }
    return pairs;
}

// The heaviest sets whose weakest pair is the given one, no pair being closer.
bool with_pair(const Picking& picking, const Graph& graph, std::pair<std::size_t, std::size_t> pair,
               BestSets& best) {
    Indices kept = picking.kept;
    for (const std::size_t v : {pair.first, pair.second}) {
        if (!std::ranges::binary_search(picking.kept, v)) kept.push_back(v);
    }
    if (kept.size() > picking.problem.count) return true;
    for (const std::size_t u : kept) {
        for (const std::size_t v : kept) {
            if (u != v && !graph.has(u, v)) return true;
        }
    }
    Indices others;
    for (const std::size_t v : picking.others) {
        const auto fits = [&](std::size_t u) { return graph.has(u, v); };
        if (std::ranges::all_of(kept, fits)) others.push_back(v);
    }
    const std::size_t missing = picking.problem.count - kept.size();
    CliqueSearch any = find_clique(graph, others, missing, picking.limit);
    if (any.verdict != CliqueVerdict::found) return any.verdict == CliqueVerdict::none;
    any.members.insert(any.members.end(), kept.begin(), kept.end());
    best.offer(heavy_set(picking.distances, any.members));
    const HeaviestProblem problem{picking.distances,     picking.real, &graph,
                                  picking.problem.count, kept,         others};
    return find_heaviest(problem, best, picking.limit, picking.threads).is_complete;
}

// Offers the heaviest sets whose weakest pair is at `value` exactly; with many such pairs, also
// sets that have none closer. False: the limit was reached.
bool offer_widest(const Picking& picking, Units value, BestSets& best) {
    Graph graph = graph_of(picking.distances, value);
    const auto pairs = pairs_at(picking, value);
    if (weakest_of(picking.distances, picking.kept) == value || pairs.size() > kMostTies) {
        HeaviestProblem problem = picking.heaviest();
        problem.graph = &graph;
        return find_heaviest(problem, best, picking.limit, picking.threads).is_complete;
    }
    for (const auto& pair : pairs) {
        if (!with_pair(picking, graph, pair, best)) return false;
        // Sets with this pair are done.
        graph.clear(pair.first, pair.second);
        graph.clear(pair.second, pair.first);
    }
    return true;
}

// As many sets as wanted by their weakest pair, then their sum, below those given already.
bool add_wider_first(const Picking& picking, Units widest, std::size_t wanted,
                     std::vector<HeavySet>& sets) {
    const std::vector<Units> values = distinct_values(picking.distances);
    auto value = std::ranges::upper_bound(values, widest);
    while (sets.size() < wanted && value != values.begin()) {
        --value;
        if (*value > weakest_of(picking.distances, picking.kept)) continue;
        BestSets best(wanted);
        if (*value == widest) {
            best.offer(sets.front());
            offer_exchanges(picking, sets.front().members, widest, best);
        }
        const bool is_complete = offer_widest(picking, *value, best);
        for (HeavySet& set : best.sets()) {
            const bool is_new = std::ranges::find(sets, set) == sets.end();
            if (is_new && sets.size() < wanted) sets.push_back(std::move(set));
        }
        if (!is_complete) return false;
    }
    return true;
}

void add_alternatives(const Picking& picking, const Dissimilarity& dissimilarity, Units widest,
                      std::size_t wanted, SubsetAnswer& answer) {
    std::vector<HeavySet> sets{heavy_set(picking.distances, answer.best.members)};
    if (picking.problem.objective == SubsetObjective::max_min) {
        answer.are_alternatives_proven = add_wider_first(picking, widest, wanted + 1, sets);
    } else {
        BestSets best(wanted + 1);
        best.offer(sets.front());
        offer_exchanges(picking, sets.front().members, std::numeric_limits<Units>::min(), best);
        answer.are_alternatives_proven =
            find_heaviest(picking.heaviest(), best, picking.limit, picking.threads).is_complete;
        sets = best.sets();
    }
    for (HeavySet& set : sets) {
        if (set.members == answer.best.members || answer.alternatives.size() == wanted) continue;
        answer.alternatives.push_back(subset_of(dissimilarity, std::move(set.members)));
    }
}

// The weakest pair as far apart as can be, then the sum as large as can be.
Units pick_max_min(const Picking& picking, const Dissimilarity& dissimilarity, Indices start,
                   const SubsetOptions& options, SubsetAnswer& answer) {
    const WidestSet widest =
        widest_set(picking.widest(), std::move(start), std::nullopt, picking.limit,
                   [&](double share, const WidestSet& now) {
                       tell_so_far(picking, dissimilarity, options, now.members, now.bound, 1);
                       tell_share(picking, options, 0.6 * share);
                   });
    BestSets best(1);
    best.offer(heavy_set(picking.distances, widest.members));
    answer.proof = SubsetProof::open;
    if (widest.bound == widest.weakest) {
        offer_exchanges(picking, widest.members, widest.weakest, best);
        const bool is_complete = offer_widest(picking, widest.weakest, best);
        answer.proof = is_complete ? SubsetProof::optimal : SubsetProof::ties_open;
    }
    answer.best = subset_of(dissimilarity, best.sets().front().members);
    answer.bound = answer.proof == SubsetProof::open
                       ? largest_meant(picking.distances, widest.bound, 1)
                       : answer.best.weakest_dissimilarity;
    return widest.weakest;
}

void pick_max_sum(const Picking& picking, const Dissimilarity& dissimilarity, Indices start,
                  const SubsetOptions& options, SubsetAnswer& answer) {
    BestSets best(1);
    best.offer(heavy_set(picking.distances, std::move(start)));
    const std::size_t pairs = pair_count(picking.problem.count);
    const HeaviestRun run = find_heaviest(
        picking.heaviest(), best, picking.limit, picking.threads, [&](double share, Units bound) {
            tell_so_far(picking, dissimilarity, options, best.sets().front().members, bound, pairs);
            tell_share(picking, options, 0.8 * share);
        });
    const HeavySet found = best.sets().front();
    answer.best = subset_of(dissimilarity, found.members);
    answer.proof = run.is_complete ? SubsetProof::optimal : SubsetProof::open;
    answer.bound = run.is_complete
                       ? answer.best.sum
                       : largest_meant(picking.distances, std::max(run.bound, found.sum), pairs);
}

std::size_t different(Indices indices) {
    std::ranges::sort(indices);
    return static_cast<std::size_t>(std::unique(indices.begin(), indices.end()) - indices.begin());
}

}  // namespace

Expected<Done> check_subset(const SubsetProblem& problem, std::size_t objects) {
    for (const Indices& indices : {problem.keep, problem.drop}) {
        if (std::ranges::any_of(indices, [&](std::size_t v) { return v >= objects; })) {
            return Error{objects == 1 ? std::string("only 1 pattern is there to pick from")
                                      : "only " + std::to_string(objects) +
                                            " patterns are there to pick from"};
        }
    }
    for (const std::size_t v : problem.keep) {
        if (std::ranges::find(problem.drop, v) != problem.drop.end()) {
            return Error{"one pattern cannot be both kept and dropped"};
        }
    }
    const std::size_t left = objects - different(problem.drop);
    const std::size_t kept = different(problem.keep);
    const std::string wanted = std::to_string(problem.count);
    if (problem.count < 2) return Error{wanted + " to pick: expected at least 2"};
    if (problem.count > left) {
        return Error{wanted + " to pick of " + std::to_string(left) + ": expected at most as many"};
    }
    if (kept > problem.count) {
        return Error{wanted + " to pick, but " + std::to_string(kept) + " must be kept"};
    }
    return Done{};
}

Subset subset_of(const Dissimilarity& dissimilarity, std::vector<std::size_t> members) {
    std::ranges::sort(members);
    Subset subset;
    subset.weakest_dissimilarity = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < members.size(); ++a) {
        for (std::size_t b = a + 1; b < members.size(); ++b) {
            const double value = dissimilarity(members[a], members[b]);
            const double distance = std::isfinite(value) ? value : 0.0;
            subset.sum += distance;
            if (distance >= subset.weakest_dissimilarity) continue;
            subset.weakest_dissimilarity = distance;
            subset.weakest = {members[a], members[b]};
        }
    }
    subset.members = std::move(members);
    return subset;
}

Expected<SubsetAnswer> most_distinct_subset(const Dissimilarity& dissimilarity,
                                            const SubsetProblem& problem,
                                            const SubsetOptions& options) {
    if (const Expected<Done> fault = check_subset(problem, dissimilarity.size); !fault) {
        return fault.error();
    }
    const Picking picking = picking_of(dissimilarity, problem, options);
    Indices start = started_subset(picking.distances, problem.objective, problem.count,
                                   picking.kept, picking.others);
    SubsetAnswer answer;
    Units widest = 0;
    if (problem.objective == SubsetObjective::max_min) {
        widest = pick_max_min(picking, dissimilarity, std::move(start), options, answer);
    } else {
        pick_max_sum(picking, dissimilarity, std::move(start), options, answer);
    }
    if (options.progress) options.progress(0.8);
    if (options.alternatives > 0 && answer.proof == SubsetProof::optimal) {
        add_alternatives(picking, dissimilarity, widest, options.alternatives, answer);
    }
    if (options.progress) options.progress(1.0);
    return answer;
}

std::vector<CurvePoint> weakest_by_count(const Dissimilarity& dissimilarity,
                                         const SubsetProblem& problem, std::size_t most,
                                         const SubsetOptions& options) {
    const Picking picking = picking_of(dissimilarity, problem, options);
    const std::size_t last = std::min(most, picking.kept.size() + picking.others.size());
    const std::size_t first = std::max<std::size_t>(2, picking.kept.size());
    std::vector<CurvePoint> curve;
    // More objects never have a wider weakest pair.
    std::optional<Units> bound;
    for (std::size_t k = first; k <= last && !options.stop.stop_requested(); ++k) {
        const WidestProblem widest{picking.distances, k, picking.kept, picking.others};
        Indices start = started_subset(picking.distances, SubsetObjective::max_min, k, picking.kept,
                                       picking.others);
        const WidestSet set = widest_set(widest, std::move(start), bound, picking.limit);
        bound = set.bound;
        const double reached = subset_of(dissimilarity, set.members).weakest_dissimilarity;
        const bool is_proven = set.bound == set.weakest;
        curve.push_back(
            {k, reached, is_proven ? reached : largest_meant(picking.distances, set.bound, 1)});
        if (options.progress) {
            options.progress(static_cast<double>(k + 1 - first) /
                             static_cast<double>(last + 1 - first));
        }
    }
    return curve;
}

}  // namespace tact
