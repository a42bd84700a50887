#include "model/ask/gap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "tests/model/ask/short_sets.h"

namespace gap_test {

using namespace tact;

namespace {

Dissimilarity random_matrix(std::size_t size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> value(1, 40);  // with ties
    Dissimilarity matrix{size, {}};
    for (std::size_t k = 0; k < pair_count(size); ++k) {
        matrix.condensed.push_back(static_cast<double>(value(random)));
    }
    return matrix;
}

// The weakest pair that has one of these in it.
double weakest(const Dissimilarity& pm, std::size_t picked, const std::vector<std::size_t>& fresh) {
    double least = 1e9;
    for (std::size_t a = 0; a < fresh.size(); ++a) {
        for (std::size_t k = 0; k < picked; ++k) least = std::min(least, pm(k, picked + fresh[a]));
        for (std::size_t b = a + 1; b < fresh.size(); ++b) {
            least = std::min(least, pm(picked + fresh[a], picked + fresh[b]));
        }
    }
    return least;
}

// Twelve of three levels each, of which some are picked.
PatternSet designed() {
    PatternSet set;
    set.duration_s = 0.1;
    DesignSpace space;
    space.amplitude_g = std::vector<double>{0.5, 1.0};
    space.carriers[0].frequency_hz = std::vector<double>{60.0, 120.0, 240.0};
    space.modulation_hz = std::vector<double>{0.0, 20.0};
    space.duration_s = fixed(0.1);
    set.generator = space;
    for (const double hz : {60.0, 120.0}) {
        Vibration vibration;
        vibration.name = std::to_string(static_cast<int>(hz));
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.amplitude_g = 1.0;
        pattern.carriers[0].frequency_hz = hz;
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace

TEST_CASE("gap: what is drawn around a number that no slider reaches stays around it") {
    PatternSet set;
    set.duration_s = 0.2;
    Vibration vibration;
    vibration.name = "far out";
    Pattern pattern;
    pattern.duration_s = 0.2;
    pattern.amplitude_g = 20.0;
    pattern.carriers[0].frequency_hz = 5.0;
    pattern.carriers.push_back({900.0, 6.0, 0.0});
    pattern.modulation.frequency_hz = 600.0;
    pattern.attack_s = 3.0;
    pattern.release_s = 2.0;
    vibration.source = pattern;
    set.vibrations.push_back(vibration);
    for (const PatternParameter free :
         {PatternParameter::amplitude, PatternParameter::carrier, PatternParameter::second_carrier,
          PatternParameter::mix, PatternParameter::modulation, PatternParameter::attack,
          PatternParameter::release}) {
        CAPTURE(traits(free).key);
        const double own = *value_of(pattern, free);
        const GapCandidates drawn = gap_candidates(set, {0}, {free}, 7);
        REQUIRE(!drawn.patterns.empty());
        bool is_higher = false;
        bool is_lower = false;
        for (const Pattern& one : drawn.patterns) {
            const double value = *value_of(one, free);
            CHECK(steps_between(set.felt_steps, free, own, value) <= kFarthestDrawnSteps + 1e-9);
            is_higher = is_higher || value > own;
            is_lower = is_lower || value < own;
        }
        CHECK(is_higher);
        CHECK(is_lower);
    }
}

TEST_CASE("gap: no candidate is farther from all picked ones than the one that is proposed") {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const std::size_t picked = 1 + seed % 5;
        const Dissimilarity pm = random_matrix(14, seed);
        const auto found = fill_gap(pm, picked, 1, {});
        REQUIRE(found);
        REQUIRE(found->chosen.size() == 1);
        double best = 0.0;
        for (std::size_t k = 0; k < 14 - picked; ++k)
            best = std::max(best, weakest(pm, picked, {k}));
        CHECK(weakest(pm, picked, found->chosen) == best);
        CHECK(found->weakest_pm == best);
        CHECK(found->is_proven);
    }
}

TEST_CASE("gap: no two candidates are better than the two that are proposed") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Dissimilarity pm = random_matrix(12, 100 + seed);
        const auto found = fill_gap(pm, 3, 2, {});
        REQUIRE(found);
        double best = 0.0;
        for (std::size_t a = 0; a < 9; ++a) {
            for (std::size_t b = a + 1; b < 9; ++b) best = std::max(best, weakest(pm, 3, {a, b}));
        }
        CHECK(found->chosen.size() == 2);
        CHECK(weakest(pm, 3, found->chosen) == best);
        CHECK(found->is_proven);
    }
}

TEST_CASE("gap: where fewer are left than are missing, all of them; of none, none") {
    const Dissimilarity pm = random_matrix(5, 1);
    CHECK(fill_gap(pm, 3, 7, {})->chosen == std::vector<std::size_t>{0, 1});
    CHECK(fill_gap(pm, 5, 1, {})->chosen.empty());
}

TEST_CASE("gap: of a design space it is what PM of all says, on any number of threads") {
    const PatternSet set = designed();
    const GapCandidates source = gap_candidates(set, {0, 1}, {}, 1);
    CHECK(source.of_space);
    CHECK(source.all_there_are);
    REQUIRE(source.patterns.size() == 10);  // two of the twelve are picked
    GapQuestion question{set.vibrations, source.patterns, 1, set.model};
    PatternSet all = set;
    for (const Pattern& one : source.patterns) {
        Vibration vibration;
        vibration.name = std::to_string(all.vibrations.size());
        vibration.source = one;
        all.vibrations.push_back(vibration);
    }
    const auto prediction = predict(model_waveforms(all), set.model);
    double best = 0.0;
    for (std::size_t k = 0; k < 10; ++k) {
        best = std::max(best, weakest(prediction->pm, 2, {k}));
    }
    for (const int threads : {1, 4}) {
        GapOptions options;
        options.threads = threads;
        const auto found = fill_gap(question, options);
        REQUIRE(found);
        CHECK(weakest(prediction->pm, 2, found->chosen) == best);
        CHECK(found->largest_pm == *std::ranges::max_element(prediction->pm.condensed));
    }
}

TEST_CASE("gap: without a design space patterns are drawn around the picked, the same by a seed") {
    const PatternSet set = short_set(4);
    const std::vector<PatternParameter> free{PatternParameter::carrier};
    const GapCandidates drawn = gap_candidates(set, {0, 2}, free, 7);
    CHECK_FALSE(drawn.of_space);
    CHECK_FALSE(drawn.all_there_are);
    CHECK(drawn.patterns.size() > kDrawnGapCandidates / 2);
    for (const Pattern& one : drawn.patterns) {
        const auto& first = std::get<Pattern>(set.vibrations[0].source);
        const auto& third = std::get<Pattern>(set.vibrations[2].source);
        const double hz = one.carriers[0].frequency_hz;
        const bool only_free = with_value(first, PatternParameter::carrier, hz) == one ||
                               with_value(third, PatternParameter::carrier, hz) == one;
        CHECK(only_free);
    }
    CHECK(gap_candidates(set, {0, 2}, free, 7).patterns == drawn.patterns);
    CHECK_FALSE(gap_candidates(set, {0, 2}, free, 8).patterns == drawn.patterns);
}

TEST_CASE("gap: a stop ends it without an answer") {
    std::stop_source stop;
    stop.request_stop();
    GapOptions options;
    options.stop = stop.get_token();
    const PatternSet set = designed();
    CHECK_FALSE(fill_gap(
        {set.vibrations, gap_candidates(set, {0, 1}, {}, 1).patterns, 1, set.model}, options));
}

}  // namespace gap_test
