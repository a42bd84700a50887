#include "model/study/agreement.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/common/distributions.h"
#include "model/common/random.h"
#include "model/study/synthetic_study.h"
#include "tests/support/golden.h"

namespace agreement_test {

using namespace tact;
using golden::Json;

namespace {

constexpr const char* kFile = "agreement.json";

// SciPy's own quantiles are found to about 1e-12.
constexpr double kNear = 1e-9;

bool is_near(double got, double expected) {
    return std::abs(got - expected) <= kNear * std::max(1.0, std::abs(expected));
}

struct Table {
    std::vector<double> cells;
    std::size_t people = 0;
};

Table table_in(const Json& rows) {
    Table table{{}, rows[0].size()};
    for (const Json& row : rows) {
        for (const Json& cell : row) table.cells.push_back(cell.get<double>());
    }
    return table;
}

// A study of just enough patterns for these pairs; nobody rated the pairs beyond.
RatingStudy study_of(std::vector<std::vector<double>> people) {
    std::size_t patterns = 2;
    while (pair_count(patterns) < people.front().size()) ++patterns;
    RatingStudy study;
    for (std::size_t k = 0; k < patterns; ++k) study.labels.push_back(std::to_string(k));
    for (std::vector<double>& ratings : people) {
        ratings.resize(pair_count(patterns), kNoRating);
        study.judgements.push_back({"P" + std::to_string(study.judgements.size()), ratings});
    }
    return study;
}

RatingStudy study_in(const Json& people) {
    std::vector<std::vector<double>> all;
    for (const Json& one : people) {
        std::vector<double>& ratings = all.emplace_back();
        for (const Json& cell : one) {
            ratings.push_back(cell.is_null() ? kNoRating : cell.get<double>());
        }
    }
    return study_of(all);
}

// Ratings as the two-way model of the ICC has them: pair + person + noise, all normal.
std::vector<double> drawn_table(std::uint64_t seed, std::size_t pairs, std::size_t people) {
    RandomStream random{random_bits(77, seed)};
    std::vector<double> of_person(people);
    for (double& bias : of_person) bias = 6.0 * next_normal(random);
    std::vector<double> table;
    for (std::size_t p = 0; p < pairs; ++p) {
        const double pair = 50.0 + 20.0 * next_normal(random);
        for (std::size_t k = 0; k < people; ++k) {
            table.push_back(pair + of_person[k] + 15.0 * next_normal(random));
        }
    }
    return table;
}

bool holds(const Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

// One person per row of differences: each pair once either way round, the mean at 50.
std::vector<StudyRecord> records_with(const std::vector<std::vector<double>>& differences,
                                      FeltFirst first = FeltFirst::unknown) {
    std::vector<StudyRecord> records;
    for (const auto& person : differences) {
        StudyRecord record;
        record.header.patterns = {"a", "b", "c"};
        record.header.participant.code = "P" + std::to_string(records.size());
        for (std::size_t p = 0; p < person.size(); ++p) {
            const auto [i, j] = pair_at(3, p);
            PairAnswer there{{i, j}, 50.0 + person[p] / 2.0, 1, 1, 5.0, ""};
            PairAnswer back{{j, i}, 50.0 - person[p] / 2.0, 1, 1, 5.0, ""};
            there.first = back.first = first;
            record.answers.push_back(there);
            record.answers.push_back(back);
        }
        records.push_back(record);
    }
    return records;
}

}  // namespace

TEST_CASE("F distribution: shares and quantiles are SciPy's, of broken degrees of freedom, too") {
    for (const Json& one : golden::read(kFile, "f")) {
        const double df1 = one.at("df1");
        const double df2 = one.at("df2");
        CAPTURE(df1);
        CAPTURE(df2);
        CHECK(is_near(f_share_below(one.at("value"), df1, df2), one.at("below")));
        CHECK(is_near(f_quantile(one.at("share"), df1, df2), one.at("quantile")));
    }
    CHECK(f_share_below(-1.0, 3, 4) == 0.0);
    CHECK(f_share_below(0.0, 3, 4) == 0.0);
}

TEST_CASE("ICC: of one person and of the mean, with intervals, as by least squares and SciPy") {
    for (const Json& one : golden::read(kFile, "icc")) {
        const Table table = table_in(one.at("table"));
        const Icc single = icc_single(table.cells, table.people);
        CHECK(is_near(single.value, one.at("single")));
        CHECK(is_near(single.interval.low, one.at("single_low")));
        CHECK(is_near(single.interval.high, one.at("single_high")));
        const Icc mean = icc_mean(table.cells, table.people);
        CHECK(is_near(mean.value, one.at("mean")));
        CHECK(is_near(mean.interval.low, one.at("mean_low")));
        CHECK(is_near(mean.interval.high, one.at("mean_high")));
    }
}

TEST_CASE("ICC: 95 % intervals hold the truth in 93 % and more of 200 drawn studies") {
    constexpr std::size_t kPeople = 12;
    const double single = 400.0 / (400.0 + 36.0 + 225.0);
    const double mean = 400.0 / (400.0 + 225.0 / kPeople);
    int held_single = 0;
    int held_mean = 0;
    int beside = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const std::vector<double> table = drawn_table(seed, 45, kPeople);
        const Interval of_single = icc_single(table, kPeople).interval;
        held_single += holds(of_single, single);
        beside += holds(of_single, mean);
        held_mean += holds(icc_mean(table, kPeople).interval, mean);
    }
    CHECK(held_single >= 186);
    CHECK(held_mean >= 186);
    CHECK(beside == 0);  // an interval that holds everything tells nothing
}

TEST_CASE("agreement: Krippendorff's alpha is that of its definition, with gaps, too") {
    for (const Json& one : golden::read(kFile, "alpha")) {
        CHECK(is_near(inter_rater(study_in(one.at("people"))).alpha, one.at("alpha")));
    }
}

TEST_CASE("agreement: pairs that some did not rate are left out of the ICC, and counted") {
    const InterRater all = inter_rater(study_of({{1, 5, 9, 4}, {2, 5, 8, kNoRating}}));
    CHECK(all.people == 2);
    CHECK(all.pairs == 3);
    CHECK(all.alpha_pairs == 3);
    CHECK(all.single.value == icc_single(std::vector<double>{1, 2, 5, 5, 9, 8}, 2).value);
}

TEST_CASE("agreement: of one person, or of people who all say the same, nothing is said") {
    const RatingStudy alone = study_of({{1, 5, 9}});
    const RatingStudy flat = study_of({{4, 4, 4}, {4, 4, 4}});
    for (const RatingStudy& study : {alone, flat, RatingStudy{}}) {
        const InterRater none = inter_rater(study);
        CHECK(std::isnan(none.single.value));
        CHECK(std::isnan(none.mean.interval.low));
        CHECK(std::isnan(none.alpha));
    }
    // Alike to the last digit: one, and no interval of what has no noise.
    const RatingStudy same = study_of({{1, 5, 9}, {1, 5, 9}});
    CHECK(inter_rater(same).single.value == 1.0);
    CHECK(inter_rater(same).alpha == 1.0);
}

TEST_CASE("order: p of the sides is that of all ways to draw them") {
    const Json signs = golden::read(kFile, "signs");
    const auto differences = signs.at("differences").get<std::vector<std::vector<double>>>();
    const OrderEffects effects = order_effects(records_with(differences));
    CHECK(effects.side.people == differences.size());
    CHECK(effects.side.comparisons == 12);
    CHECK(effects.side.is_exact);
    CHECK(effects.side.signs == 4096);
    CHECK(is_near(effects.side.p, signs.at("p")));
    double sum = 0.0;
    for (const auto& person : differences) {
        for (const double one : person) sum += one;
    }
    CHECK(is_near(effects.side.mean, sum / 12.0));
    CHECK(effects.felt_first.comparisons == 0);  // not known of these answers
    CHECK(std::isnan(effects.felt_first.p));
}

TEST_CASE("order: who felt the right side first has the order against the sides") {
    const std::vector<std::vector<double>> differences{{8, 2, 5}, {6, 3, 7}};
    const OrderEffects left = order_effects(records_with(differences, FeltFirst::left));
    const OrderEffects right = order_effects(records_with(differences, FeltFirst::right));
    CHECK(left.felt_first.mean == left.side.mean);
    CHECK(right.felt_first.mean == -right.side.mean);
    CHECK(right.side.mean == left.side.mean);
}

TEST_CASE("order: p of drawn signs is never below one of all draws, and of all signs never 0") {
    // 30 people with one shift: drawn signs of that many are never all alike.
    const std::vector<std::vector<double>> many(30, {20.0, 20.0, 20.0});
    const Shift drawn = order_effects(records_with(many)).side;
    CHECK_FALSE(drawn.is_exact);
    CHECK(drawn.signs == kOrderDraws);
    CHECK(drawn.p == 1.0 / static_cast<double>(kOrderDraws + 1));
    CHECK(signs_text(drawn) == "5,000 drawn signs");
    // Four people, one pair: all alike is two of the 16 ways.
    const Shift exact = order_effects(records_with({{9.0}, {9.0}, {9.0}, {9.0}})).side;
    CHECK(exact.p == 2.0 / 16.0);
    CHECK(signs_text(exact) == "all 16 signs");
}

TEST_CASE("order: of one person there is no test, as no signs change the number") {
    const Shift alone = order_effects(records_with({{8.0, 2.0, 5.0}})).side;
    CHECK(alone.people == 1);
    CHECK(alone.mean == 5.0);
    CHECK(std::isnan(alone.p));
    CHECK(signs_text(alone).starts_with("no test"));
}

TEST_CASE("order: a shift that all share is found, noise alone is found one time in twenty" *
          doctest::test_suite("long")) {
    int found = 0;
    int false_alarms = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        RandomStream random{random_bits(5, seed)};
        std::vector<std::vector<double>> noise(8, std::vector<double>(3));
        for (auto& person : noise) {
            for (double& one : person) one = 10.0 * next_normal(random);
        }
        false_alarms += order_effects(records_with(noise)).side.p <= 0.05;
        for (auto& person : noise) person[1] += 20.0;  // of one pair alone
        found += order_effects(records_with(noise)).side.p <= 0.05;
    }
    CHECK(false_alarms <= 20);  // 10 expected; 20 is three standard errors above
    CHECK(false_alarms >= 1);
    CHECK(found >= 150);
}

TEST_CASE("order: practice is the last pass against the first, in points of similarity") {
    std::vector<StudyRecord> records;
    for (int k = 0; k < 8; ++k) {
        StudyRecord record;
        record.header.patterns = {"a", "b"};
        record.header.participant.code = "P" + std::to_string(k);
        const double first = 40.0 + k;
        record.answers = {{{0, 1}, first, 1, 1, 5.0, ""},
                          {{1, 0}, 90.0, 1, 1, 5.0, ""},
                          {{0, 1}, first + 5.0, 1, 1, 5.0, ""}};
        records.push_back(record);
    }
    const Shift practice = order_effects(records).practice;
    CHECK(practice.people == 8);
    CHECK(practice.mean == 5.0);
    CHECK(practice.p < 0.03);  // two of 256 ways are as far from zero
    CHECK(practice.p > 0.002);
}

}  // namespace agreement_test
