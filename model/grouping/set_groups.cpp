#include "model/grouping/set_groups.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/dissimilarity/correlation.h"

namespace tact {

namespace {

PatternGroup group_of(std::vector<std::size_t> members, const Dissimilarity& dissimilarity) {
    PatternGroup group;
    group.central = most_central(dissimilarity, members);
    group.far_a = group.far_b = members.front();
    double sum = 0.0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        for (std::size_t j = i + 1; j < members.size(); ++j) {
            const double apart = dissimilarity(members[i], members[j]);
            sum += apart;
            if (group.far_a != group.far_b && !(apart > group.farthest)) continue;
            group.far_a = members[i];
            group.far_b = members[j];
            group.farthest = apart;
        }
    }
    if (members.size() > 1) group.mean = sum / static_cast<double>(pair_count(members.size()));
    group.members = std::move(members);
    return group;
}

nlohmann::json names_at(std::span<const std::size_t> places,
                        const std::vector<std::string>& names) {
    nlohmann::json list = nlohmann::json::array();
    for (const std::size_t place : places) list.push_back(names[place]);
    return list;
}

// Null where there is no such number.
nlohmann::json number_or_null(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace

SetGroups groups_of_set(const PatternSet& set, const Dissimilarity& dissimilarity,
                        std::span<const std::size_t> unfelt) {
    SetGroups groups;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        const bool is_unfelt = std::ranges::find(unfelt, k) != unfelt.end();
        (is_unfelt                   ? groups.unfelt
         : set.vibrations[k].dropped ? groups.dropped
                                     : groups.grouped)
            .push_back(k);
    }
    const Dissimilarity counted = among(dissimilarity, groups.grouped);
    groups.tree = group_tree(counted);
    groups.agreement = spearman(joined_at(groups.tree).condensed, counted.condensed);
    return groups;
}

std::size_t usual_group_count(std::size_t patterns) {
    constexpr std::size_t kUsual = 8;
    return std::min((patterns + 1) / 2, kUsual);
}

Expected<std::size_t> asked_group_count(const SetGroups& groups, const AskedGroups& asked) {
    if (asked.cut) return group_count(groups.tree, *asked.cut);
    const std::size_t patterns = groups.grouped.size();
    const std::size_t count = asked.count.value_or(usual_group_count(patterns));
    if (count <= patterns) return count;
    return Error{"expected at most " + std::to_string(patterns) +
                 ", the number of patterns that are felt and not dropped, got " +
                 std::to_string(count)};
}

std::vector<PatternGroup> groups_at(const SetGroups& groups, const Dissimilarity& dissimilarity,
                                    std::size_t count) {
    const std::vector<std::size_t> group = clusters(groups.tree, count);
    std::vector<std::vector<std::size_t>> members;  // in the order of the leaves
    std::size_t last = group.size();
    for (const std::size_t leaf : clustered_order(groups.tree)) {
        if (members.empty() || group[leaf] != last) members.emplace_back();
        last = group[leaf];
        members.back().push_back(groups.grouped[leaf]);
    }
    std::vector<PatternGroup> result;
    for (std::vector<std::size_t>& one : members) {
        std::ranges::sort(one);
        result.push_back(group_of(std::move(one), dissimilarity));
    }
    return result;
}

std::vector<std::size_t> standing_for(const PatternSet& set, std::span<const PatternGroup> groups) {
    std::vector<std::size_t> places;
    for (const PatternGroup& group : groups) {
        const std::size_t before = places.size();
        std::ranges::copy_if(group.members, std::back_inserter(places),
                             [&set](std::size_t k) { return set.vibrations[k].locked; });
        if (places.size() == before) places.push_back(group.central);
    }
    std::ranges::sort(places);
    return places;
}

nlohmann::json json_of(const SetGroups& groups, std::span<const PatternGroup> cut,
                       const std::vector<std::string>& names) {
    const auto [from, below] = cuts_of(groups.tree, cut.size());
    nlohmann::json json{{"linkage", "average"},
                        {"count", cut.size()},
                        {"cut", {{"from", from}, {"below", number_or_null(below)}}},
                        {"agreement", number_or_null(groups.agreement)},
                        {"groups", nlohmann::json::array()},
                        {"not_felt", names_at(groups.unfelt, names)},
                        {"dropped", names_at(groups.dropped, names)},
                        {"order", names_at(groups.grouped, names)},
                        {"joins", nlohmann::json::array()}};
    for (const PatternGroup& group : cut) {
        nlohmann::json one{{"patterns", names_at(group.members, names)},
                           {"central", names[group.central]}};
        if (group.members.size() > 1) {
            one["mean"] = number_or_null(group.mean);
            one["farthest"] = {{"a", names[group.far_a]},
                               {"b", names[group.far_b]},
                               {"dissimilarity", number_or_null(group.farthest)}};
        }
        json["groups"].push_back(one);
    }
    for (const GroupJoin& join : groups.tree.joins) {
        json["joins"].push_back({join.a, join.b, join.height, join.objects});
    }
    return json;
}

}  // namespace tact
