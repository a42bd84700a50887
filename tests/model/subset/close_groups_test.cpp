#include "model/subset/close_groups.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>

namespace close_groups_test {

using namespace tact;

namespace {

using Places = std::vector<std::size_t>;

// Objects on a line.
Dissimilarity on_a_line(const std::vector<double>& at) {
    Dissimilarity result{at.size(), {}};
    for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = i + 1; j < at.size(); ++j) {
            result.condensed.push_back(std::abs(at[j] - at[i]));
        }
    }
    return result;
}

std::vector<Places> members_of(const CloseGroups& close) {
    std::vector<Places> all;
    for (const CloseGroup& group : close.groups) all.push_back(group.members);
    return all;
}

// Two are in one group if steps below the threshold lead from one to the other: by Warshall.
std::vector<std::vector<bool>> reachable(const Dissimilarity& d, double threshold) {
    std::vector<std::vector<bool>> reach(d.size, std::vector<bool>(d.size, false));
    for (std::size_t i = 0; i < d.size; ++i) {
        for (std::size_t j = 0; j < d.size; ++j) reach[i][j] = i == j || d(i, j) < threshold;
    }
    for (std::size_t k = 0; k < d.size; ++k) {
        for (std::size_t i = 0; i < d.size; ++i) {
            for (std::size_t j = 0; j < d.size; ++j) {
                if (reach[i][k] && reach[k][j]) reach[i][j] = true;
            }
        }
    }
    return reach;
}

}  // namespace

TEST_CASE("close groups: chains below the threshold are groups, and their ends may be far apart") {
    const CloseGroups found = groups_below(on_a_line({10.0, 0.0, 1.0, 2.0, 10.5, 20.0}), 1.5);
    CHECK((members_of(found) == std::vector<Places>{{1, 2, 3}, {0, 4}}));
    CHECK((found.groups[0].closest == ConfusablePair{1, 2, 1.0}));
    CHECK((found.groups[0].farthest == ConfusablePair{1, 3, 2.0}));
    CHECK(found.pairs == 3);
    CHECK((found.links == std::vector<ConfusablePair>{{0, 4, 0.5}, {1, 2, 1.0}, {2, 3, 1.0}}));
    CHECK(distinct_count(found) == 3);
    const Places nearest{4, 2, 1, 2, 0, 4};
    for (std::size_t i = 0; i < nearest.size(); ++i) CHECK(found.nearest[i].place == nearest[i]);
    CHECK(found.nearest[5].dissimilarity == 9.5);
}

TEST_CASE(
    "close groups: a pair at a threshold is not below it, so a subset's weakest pair is clear") {
    const Dissimilarity d = on_a_line({0.0, 4.0, 8.0});
    CHECK(groups_below(d, 4.0).groups.empty());
    CHECK(groups_below(d, std::nextafter(4.0, 5.0)).groups.size() == 1);
}

TEST_CASE("close groups: groups are what can be reached, whatever the order of the objects") {
    std::uint64_t state = 7;
    const auto next = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 33U) / 2147483648.0;
    };
    for (int round = 0; round < 50; ++round) {
        std::vector<double> at(12);
        for (double& one : at) one = 10.0 * next();
        const double threshold = 0.2 + next();
        const Dissimilarity d = on_a_line(at);
        const CloseGroups found = groups_below(d, threshold);
        const auto reach = reachable(d, threshold);
        CHECK(found.links.size() == at.size() - distinct_count(found));
        std::vector<std::size_t> group_of(at.size());
        for (std::size_t i = 0; i < at.size(); ++i) group_of[i] = 100 + i;  // by itself
        for (std::size_t g = 0; g < found.groups.size(); ++g) {
            CHECK(std::ranges::is_sorted(found.groups[g].members));
            for (const std::size_t i : found.groups[g].members) group_of[i] = g;
        }
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (std::size_t j = 0; j < at.size(); ++j) {
                CHECK((group_of[i] == group_of[j]) == reach[i][j]);
            }
        }
    }
}

TEST_CASE("close groups: a higher threshold only ever joins, until all is one group") {
    const Dissimilarity d = on_a_line({0.0, 1.0, 3.0, 6.0, 10.0, 15.0});
    std::size_t before = 6;
    for (double threshold = 0.5; threshold < 7.0; threshold += 0.5) {
        const std::size_t now = distinct_count(groups_below(d, threshold));
        CHECK(now <= before);
        before = now;
    }
    CHECK(before == 1);
}

TEST_CASE("close groups: pairs that nobody rated join nothing, and nothing is nobody's neighbour") {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const CloseGroups found = groups_below({3, {kNone, kNone, 1.0}}, 2.0);
    CHECK((members_of(found) == std::vector<Places>{{1, 2}}));
    CHECK(std::isinf(found.nearest[0].dissimilarity));
    CHECK(groups_below({0, {}}, 1.0).groups.empty());
    CHECK(distinct_count(groups_below({1, {}}, 1.0)) == 1);
}

TEST_CASE("close groups: people would confuse what is within a felt step, at whatever distance") {
    PatternSet set;
    for (const double amplitude_g : {1.0, 1.1, 1.3, 3.0}) {
        Vibration one;
        one.name = std::to_string(amplitude_g);
        Pattern pattern;
        pattern.amplitude_g = amplitude_g;
        one.source = pattern;
        set.vibrations.push_back(one);
    }
    // The two that are within a step, 1 and 1.1 g and 1.1 and 1.3 g, are the farthest of all.
    const Dissimilarity apart{4, {90.0, 1.0, 2.0, 80.0, 3.0, 4.0}};
    const CloseGroups found = groups_within_a_step(set, apart);
    CHECK((members_of(found) == std::vector<Places>{{0, 1, 2}}));
    CHECK(found.pairs == 2);
    CHECK(distinct_count(found) == 2);
    CHECK(groups_below(apart, 5.0).pairs == 4);  // closer than something: another question
}

TEST_CASE("verdicts: of felt steps alone, whatever PM says, and one word each") {
    PatternSet set;
    const auto add = [&set](auto change) {
        Pattern pattern;
        change(pattern);
        Vibration one;
        one.name = "p" + std::to_string(set.vibrations.size());
        one.source = pattern;
        set.vibrations.push_back(one);
    };
    add([](Pattern&) {});
    add([](Pattern& p) { p.amplitude_g *= 1.18; });
    add([](Pattern& p) { p.amplitude_g *= 1.3; });
    add([](Pattern& p) { p.amplitude_g *= 1.5; });
    add([](Pattern& p) { p.rhythm.text = "x-x---"; });
    add([](Pattern& p) { p.duration_s *= 1.17; });
    add([](Pattern& p) { p.duration_s *= 1.4; });
    Vibration recording = set.vibrations[0];
    Measurement measured;
    measured.waveform = std::make_shared<const Waveform>(render(Pattern{}));
    recording.source = measured;
    set.vibrations.push_back(recording);
    set.vibrations.push_back(recording);
    constexpr PairVerdict kExpected[] = {PairVerdict::same,  PairVerdict::same,  PairVerdict::close,
                                         PairVerdict::clear, PairVerdict::shape, PairVerdict::close,
                                         PairVerdict::clear, PairVerdict::shape};
    for (std::size_t k = 0; k < std::size(kExpected); ++k) {
        CAPTURE(k);
        CHECK(pair_verdict(set, 0, k) == kExpected[k]);
        CHECK(pair_verdict(set, k, 0) == kExpected[k]);
        if (k < 7) CHECK((kExpected[k] == PairVerdict::same) == within_a_step(set, 0, k));
    }
    CHECK(pair_verdict(set, 7, 8) == PairVerdict::same);  // to the sample
    set.felt_steps.size[0] = 1.6;                         // somebody who feels less
    CHECK(pair_verdict(set, 0, 3) == PairVerdict::same);
    std::set<std::string> words;
    for (const PairVerdict verdict : kPairVerdicts) words.insert(words_of(verdict));
    CHECK(words.size() == std::size(kPairVerdicts));
}

}  // namespace close_groups_test
