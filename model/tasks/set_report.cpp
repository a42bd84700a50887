#include "model/tasks/set_report.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "model/subset/set_subset.h"

namespace tact {

namespace {

SubsetProblem problem_of(const PatternSet& meant, const SetReportRequest& request,
                         std::span<const std::size_t> unpickable) {
    const std::size_t patterns = meant.vibrations.size();
    SubsetProblem problem = subset_problem(meant, 0, SubsetObjective::max_min, unpickable);
    // Half of a small set: the most distinct of all but one would say nothing.
    problem.count = request.count.value_or(
        possible_count(problem, patterns, std::max(usual_group_count(patterns), std::size_t{2})));
    return problem;
}

double threshold_of(const SetReportRequest& request, const SetReport& report) {
    if (request.closer_than) return *request.closer_than;
    if (const auto& pair = request.closer_than_pair) {
        return report.pairs.apart(pair->first, pair->second);
    }
    return report.subset.best.weakest_dissimilarity;
}

// False when stopped.
bool add_map(const PatternSet& felt, const SubsetProblem& problem, const SetReportRequest& request,
             SetReport& report) {
    MdsParams params = standard_mds_params(report.pairs.apart.size, 3);
    params.threads = request.threads;
    report.space = nonmetric_mds(report.pairs.apart, params, request.stop);
    if (request.draws == 0) return !request.stop.stop_requested();
    StabilityParams sure;
    sure.draws = request.draws;
    sure.threads = request.threads;
    sure.stop = request.stop;
    sure.progress = request.drawing;
    report.stability =
        subset_stability(felt, problem, report.subset.best, report.space.points, sure);
    return report.stability.has_value();
}

nlohmann::json names_at(std::span<const std::size_t> places, const PatternSet& set) {
    nlohmann::json names = nlohmann::json::array();
    for (const std::size_t place : places) names.push_back(set.vibrations[place].name);
    return names;
}

nlohmann::json json_of(const CloseGroups& close, const PatternSet& set) {
    nlohmann::json groups = nlohmann::json::array();
    for (const CloseGroup& group : close.groups) groups.push_back(names_at(group.members, set));
    return groups;
}

// A pattern that was compared with none has itself for nearest, at no distance and with no verdict.
nlohmann::json json_of(const NearestNeighbour& nearest, std::size_t place, const PatternSet& set) {
    nlohmann::json json{{"pattern", set.vibrations[nearest.place].name},
                        {"dissimilarity", nullptr},
                        {"verdict", nullptr}};
    if (!nearest.exists_for(place)) return json;
    json["dissimilarity"] = nearest.dissimilarity;
    json["verdict"] = words_of(pair_verdict(set, place, nearest.place));
    return json;
}

}  // namespace

Dissimilarity felt_pairs(Dissimilarity apart, std::span<const std::size_t> unfelt) {
    for (const std::size_t k : unfelt) {
        for (std::size_t other = 0; other < apart.size; ++other) {
            if (other == k) continue;
            const auto [i, j] = std::minmax(k, other);
            apart.condensed[pair_index(apart.size, i, j)] = std::numeric_limits<double>::infinity();
        }
    }
    return apart;
}

AlikePatterns alike_patterns(const PatternSet& meant, const SetPairs& pairs, double threshold,
                             std::size_t groups) {
    const Dissimilarity felt = felt_pairs(pairs.apart, pairs.unfelt);
    return {groups_within_a_step(meant, felt), groups_below(felt, threshold),
            groups_at(groups_of_set(meant, pairs.apart, pairs.unfelt), pairs.apart, groups)};
}

std::optional<SetReport> set_report(const PatternSet& meant, const PatternSet& felt,
                                    const SetReportRequest& request) {
    PairsRequest comparing;
    comparing.options.threads = request.threads;
    comparing.options.stop = request.stop;
    comparing.options.progress = request.comparing;
    auto pairs = set_pairs(felt, comparing);
    if (!pairs) return std::nullopt;
    SetReport report;
    report.pairs = *std::move(pairs);
    const std::vector<std::size_t> none;
    const auto& unpickable = request.picks_unfelt ? none : report.pairs.unfelt;
    report.left_out = left_out_unfelt(meant, unpickable);
    SubsetOptions picking = request.picking;
    picking.threads = request.threads;
    picking.stop = request.stop;
    SubsetProblem problem = problem_of(meant, request, unpickable);
    auto subset = most_distinct_subset(report.pairs.apart, problem, picking);
    if (request.stop.stop_requested()) return std::nullopt;
    if (!subset) {
        report.fault = subset.error().message;
        return report;
    }
    report.subset = *std::move(subset);
    report.closer_than = threshold_of(request, report);
    report.alike =
        alike_patterns(meant, report.pairs, report.closer_than, report.subset.best.members.size());
    if (!add_map(felt, problem, request, report)) return std::nullopt;
    return report;
}

nlohmann::json json_of(const SetReport& report, const PatternSet& meant) {
    const AlikePatterns& alike = report.alike;
    nlohmann::json json{{"groups", json_of(alike.confused, meant)},
                        {"confused_pairs", alike.confused.pairs},
                        {"distinct", distinct_count(alike.confused)},
                        {"closer_below", report.closer_than},
                        {"closer_pairs", alike.closer.pairs},
                        {"closer_groups", json_of(alike.closer, meant)},
                        {"optimal", report.subset.proof == SubsetProof::optimal},
                        {"bound", report.subset.bound},
                        {"picked", names_at(report.subset.best.members, meant)},
                        {"alike", nlohmann::json::array()}};
    for (const PatternGroup& group : alike.groups) {
        json["alike"].push_back({{"central", meant.vibrations[group.central].name},
                                 {"patterns", names_at(group.members, meant)}});
    }
    if (!report.pairs.unfelt.empty()) json["not_felt"] = names_at(report.pairs.unfelt, meant);
    if (!report.left_out.empty()) json["left_out_unfelt"] = names_at(report.left_out, meant);
    for (std::size_t k = 0; k < meant.vibrations.size(); ++k) {
        json["nearest"][meant.vibrations[k].name] = json_of(alike.closer.nearest[k], k, meant);
    }
    return json;
}

}  // namespace tact
