// Groups of a set: what is part of them, who stands for each, and what is told of them.
#include "model/grouping/set_groups.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/common/random.h"

namespace set_groups_test {

using namespace tact;

namespace {

PatternSet set_of(std::size_t patterns) {
    PatternSet set;
    for (std::size_t k = 0; k < patterns; ++k) {
        Vibration vibration;
        vibration.name = "p" + std::to_string(k);
        vibration.source = Pattern{};
        set.vibrations.push_back(vibration);
    }
    return set;
}

Dissimilarity ranked(std::size_t n) {
    RandomStream random{21};
    Dissimilarity d{n, std::vector<double>(pair_count(n))};
    for (double& value : d.condensed) value = next_even(random);
    d.condensed = average_ranks(d.condensed);
    return d;
}

}  // namespace

TEST_CASE(
    "set groups: what nobody feels and what is dropped is apart, all others are grouped once") {
    PatternSet set = set_of(20);
    set.vibrations[3].dropped = true;
    set.vibrations[4].dropped = true;
    const Dissimilarity d = ranked(20);
    const std::vector<std::size_t> unfelt{4, 9};
    const SetGroups groups = groups_of_set(set, d, unfelt);
    CHECK(groups.unfelt == unfelt);
    CHECK(groups.dropped == std::vector<std::size_t>{3});
    CHECK(groups.tree.size == 17);
    CHECK(groups.agreement > 0.0);
    for (const std::size_t count : {1U, 4U, 17U}) {
        std::vector<std::size_t> seen;
        const std::vector<PatternGroup> cut = groups_at(groups, d, count);
        CHECK(cut.size() == count);
        for (const PatternGroup& group : cut) {
            CHECK(std::ranges::is_sorted(group.members));
            CHECK(std::ranges::binary_search(group.members, group.central));
            seen.insert(seen.end(), group.members.begin(), group.members.end());
        }
        std::ranges::sort(seen);
        CHECK(seen == groups.grouped);
    }
}

TEST_CASE("set groups: a group's mean and farthest pair are those of its pairs") {
    const PatternSet set = set_of(12);
    const Dissimilarity d = ranked(12);
    const std::vector<PatternGroup> cut = groups_at(groups_of_set(set, d, {}), d, 3);
    for (const PatternGroup& group : cut) {
        double sum = 0.0;
        double most = 0.0;
        double pairs = 0.0;
        for (const std::size_t i : group.members) {
            for (const std::size_t j : group.members) {
                if (j <= i) continue;
                sum += d(i, j);
                most = std::max(most, d(i, j));
                pairs += 1.0;
            }
        }
        CHECK(group.farthest == most);
        CHECK(d(group.far_a, group.far_b) == most);
        if (pairs > 0.0) CHECK(group.mean == sum / pairs);  // ranks: the sum is exact
    }
}

TEST_CASE("set groups: the central pattern stands for a group, unless some of it are locked") {
    PatternSet set = set_of(12);
    const Dissimilarity d = ranked(12);
    const std::vector<PatternGroup> cut = groups_at(groups_of_set(set, d, {}), d, 3);
    std::vector<std::size_t> central;
    for (const PatternGroup& group : cut) central.push_back(group.central);
    std::ranges::sort(central);
    CHECK(standing_for(set, cut) == central);
    const PatternGroup& large = *std::ranges::max_element(
        cut, {}, [](const PatternGroup& group) { return group.members.size(); });
    REQUIRE(large.members.size() > 2);
    for (const std::size_t k : large.members) set.vibrations[k].locked = k != large.central;
    const std::vector<std::size_t> standing = standing_for(set, cut);
    CHECK_FALSE(std::ranges::binary_search(standing, large.central));
    CHECK(standing.size() == cut.size() - 1 + large.members.size() - 1);
}

TEST_CASE("set groups: JSON has the groups, the tree and what is apart") {
    PatternSet set = set_of(6);
    set.vibrations[0].dropped = true;
    const Dissimilarity d = ranked(6);
    const SetGroups groups = groups_of_set(set, d, std::vector<std::size_t>{5});
    const nlohmann::json json =
        json_of(groups, groups_at(groups, d, 2), {"p0", "p1", "p2", "p3", "p4", "p5"});
    CHECK(json["count"] == 2);
    CHECK(json["not_felt"] == nlohmann::json{"p5"});
    CHECK(json["dropped"] == nlohmann::json{"p0"});
    CHECK(json["joins"].size() == 3);
    CHECK(json["joins"].back()[3] == 4);
    CHECK(json["cut"]["from"] <= json["cut"]["below"]);
    std::size_t patterns = 0;
    for (const auto& group : json["groups"]) patterns += group["patterns"].size();
    CHECK(patterns == 4);
    const nlohmann::json all = json_of(groups, groups_at(groups, d, 1), names_of(set));
    CHECK(all["cut"]["below"].is_null());
}

TEST_CASE("set groups: a usual number is eight, or half of a small set") {
    CHECK(usual_group_count(1000) == 8);
    CHECK(usual_group_count(12) == 6);
    CHECK(usual_group_count(3) == 2);
    CHECK(usual_group_count(1) == 1);
    CHECK(usual_group_count(0) == 0);
}

}  // namespace set_groups_test
