#include "model/evaluation/evaluation.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "assets/assets.h"
#include "model/common/random.h"
#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "tests/support/golden.h"
#include "tests/support/temporary_folder.h"

namespace evaluation_test {

using namespace tact;
using Eigen::MatrixXd;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

EvaluationParams quick() {
    EvaluationParams params;
    params.rho_orders = 200;
    params.k_orders = 200;
    params.bootstrap_draws = 100;
    params.spread_starts = 5;
    params.chance_draws = 1000;
    params.stress_draws = 10;
    return params;
}

Dissimilarity of_random_points(Eigen::Index n, std::uint64_t seed) {
    RandomStream random{seed};
    MatrixXd points(n, 3);
    for (Eigen::Index e = 0; e < points.size(); ++e) points.data()[e] = next_normal(random);
    return {static_cast<std::size_t>(n), distances(points)};
}

Dissimilarity disturbed(Dissimilarity d, double noise) {
    const auto errors = golden::noise(9, d.condensed.size(), noise).samples_g;
    for (std::size_t p = 0; p < errors.size(); ++p) d.condensed[p] += errors[p];
    return d;
}

RatedSet rated(const Dissimilarity& ratings) {
    auto set = rated_set(ratings, quick());
    REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
    return *std::move(set);
}

// A cell of Table 2; none where the paper prints "-".
std::optional<double> printed(const std::string& cell) {
    if (cell == "na") return std::nullopt;
    if (cell == "<.01") return 0.005;
    const auto value = finite_number_in(cell);
    REQUIRE_MESSAGE(value, cell);
    return value;
}

struct Table2 {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

Table2 table2() {
    std::string_view text = asset("reference/pm_table2.csv");
    while (text.starts_with('#')) text.remove_prefix(text.find('\n') + 1);
    CsvReader reader{text};
    Table2 table{next_record(reader).fields, {}};
    for (CsvRecord record = next_record(reader); record.line != 0; record = next_record(reader)) {
        table.rows.push_back(record.fields);
    }
    return table;
}

}  // namespace

TEST_CASE("evaluation: a metric that says what people say agrees in every way") {
    const Dissimilarity people = of_random_points(9, 1);
    const RatedSet set = rated(people);
    Dissimilarity same = people;
    for (double& value : same.condensed) value = std::exp(value);
    const Evaluation e = evaluate(same, set, quick());
    CHECK(e.rho == 1.0);
    CHECK(e.tau_b == 1.0);
    // No draw of patterns moves it: an interval of no width would say that nothing could be surer.
    CHECK(std::isnan(e.rho_interval.low));
    CHECK(e.rho_p == 1.0 / 201.0);
    // Many maps fit the order of 36 distances; which one is found hangs on the start.
    CHECK(e.k < 0.15);
    CHECK(e.k_spread.low <= e.k);
    CHECK(e.k <= e.k_spread.high);
    CHECK(e.k_maps >= 1);
    CHECK(e.k_p == 1.0 / 201.0);
    CHECK(e.k_corrected > 0.7);
    CHECK(evaluate(people, set, quick()).k <= 1e-14);
    CHECK(e.stress1 < 1e-3);
    CHECK(e.remarks == std::vector<std::string>{"no interval: no other patterns move rho, or most "
                                                "leave it undefined"});
    CHECK_FALSE(e.is_failed_map);
    CHECK_FALSE(e.is_failed_start);
}

TEST_CASE("evaluation: the more noise, the less agreement; without relation, none but chance") {
    const Dissimilarity people = of_random_points(10, 2);
    const RatedSet set = rated(people);
    const Evaluation near = evaluate(disturbed(people, 0.3), set, quick());
    const Evaluation far = evaluate(disturbed(people, 1.5), set, quick());
    const Evaluation none = evaluate(of_random_points(10, 77), set, quick());
    CHECK(near.rho > far.rho);
    CHECK(far.rho > none.rho);
    CHECK(near.k < far.k);
    CHECK(near.rho_p <= 0.01);
    CHECK(none.rho_p > 0.02);
    CHECK(none.k_p > 0.02);
    CHECK(std::abs(none.k - set.k_chance.mean) < 0.15);
    CHECK(std::abs(none.k_corrected) < 0.3);
}

TEST_CASE("evaluation: what is undefined is NaN and says why") {
    const RatedSet set = rated(of_random_points(8, 3));
    const Evaluation flat = evaluate({8, std::vector<double>(28, 2.0)}, set, quick());
    CHECK(std::isnan(flat.rho));
    CHECK(std::isnan(flat.rho_p));
    CHECK(std::isnan(flat.k));
    CHECK(flat.is_failed_map);
    CHECK(flat.remarks ==
          std::vector<std::string>{"no rho: the rated pairs are all equally dissimilar",
                                   "no K: equal dissimilarities make no map"});
    // Two twins: SMACOF makes a map, a start from classical scaling has them on one spot.
    Dissimilarity twins = of_random_points(8, 4);
    for (std::size_t k = 2; k < 8; ++k) {
        twins.condensed[pair_index(8, 0, k)] = twins.condensed[pair_index(8, 1, k)];
    }
    twins.condensed[0] = 0.0;
    const Evaluation e = evaluate(twins, set, quick());
    CHECK(e.is_failed_start);
    CHECK_FALSE(e.is_failed_map);
    CHECK(agreement_of(e, Bookkeeping::plain).k == e.k);
    CHECK(std::isnan(agreement_of(e, Bookkeeping::paper).k));
}

TEST_CASE("evaluation: two groups of patterns have a K, by a map in which they do not collapse") {
    Dissimilarity people{10, {}};
    for (std::size_t p = 0; p < pair_count(10); ++p) {
        const auto [i, j] = pair_at(10, p);
        people.condensed.push_back(((i < 5) == (j < 5) ? 10.0 : 70.0) +
                                   static_cast<double>((p * 7) % 13));
    }
    const RatedSet set = rated(people);
    CHECK(remark_on_people_map(set).starts_with("the map of the ratings: groups of patterns"));
    const Evaluation e = evaluate(of_random_points(10, 3), set, quick());
    CHECK(e.k > 0.0);
    CHECK(e.k < 1.0);
    const Evaluation same = evaluate(people, set, quick());
    CHECK(same.k < 1e-6);
    REQUIRE(same.remarks.size() == 2);
    CHECK(same.remarks[0].starts_with("no interval"));
    CHECK(same.remarks[1].starts_with("groups of patterns collapse"));
}

TEST_CASE("evaluation: where the people's map collapses it is said once, and the paper has its K") {
    // Two groups within which nothing differs by what a map could show.
    Dissimilarity people{10, {}};
    for (std::size_t p = 0; p < pair_count(10); ++p) {
        const auto [i, j] = pair_at(10, p);
        people.condensed.push_back(((i < 5) == (j < 5) ? 10.0 : 70.0) +
                                   1e-3 * static_cast<double>((p * 7) % 13));
    }
    const RatedSet set = rated(people);
    REQUIRE(set.people.maps.empty());
    CHECK(remark_on_people_map(set).starts_with(
        "no metric has a K, as the map of the ratings is degenerate: 10 patterns lie on 2 spots"));
    const Evaluation e = evaluate(of_random_points(10, 3), set, quick());
    CHECK(e.remarks.empty());
    CHECK(std::isnan(e.k));
    const Agreement paper = agreement_of(e, Bookkeeping::paper);
    CHECK(paper.k >= 0.0);
    CHECK(paper.k < 1.0);
    // Not counted as a failed map, which would be K = 1 in the paper's mean.
    const std::vector<Agreement> one{paper};
    CHECK(mean_agreement(one, Bookkeeping::paper).k == paper.k);
    CHECK(mean_agreement(one, Bookkeeping::paper).failed_maps == 0);
    CHECK(remark_on_people_map(rated(of_random_points(8, 3))).empty());
}

TEST_CASE("evaluation: what holds for several metrics is said once") {
    std::vector<Evaluation> all(3);
    all[0].remarks = {"no rho", "no K"};
    all[2].remarks = {"no K"};
    const std::vector<std::string> keys{"a", "b", "c"};
    CHECK(remarks_by_metric(keys, all) == std::vector<std::string>{"a: no rho", "a, c: no K"});
}

TEST_CASE("evaluation: pairs that nobody rated have no say") {
    Dissimilarity people = of_random_points(9, 5);
    const Dissimilarity metric = disturbed(people, 0.5);
    people.condensed[7] = kUnknown;
    people.condensed[20] = kUnknown;
    Dissimilarity other = metric;
    other.condensed[7] = 0.1;
    other.condensed[20] = 5.0;
    const RatedSet set = rated(people);
    CHECK(evaluate(metric, set, quick()).rho == evaluate(other, set, quick()).rho);
    CHECK(std::isfinite(evaluate(metric, set, quick()).k));
}

TEST_CASE("evaluation: ratings that cannot be compared with are refused") {
    const auto fault = [](const Dissimilarity& ratings) {
        const auto set = rated_set(ratings, quick());
        REQUIRE_FALSE(set);
        return set.error().message;
    };
    CHECK(fault({2, {1}}) == "expected ratings of at least three patterns, got 2");
    CHECK(fault({4, std::vector<double>(6, 50.0)}) ==
          "expected ratings that differ, got the same for every rated pair");
    CHECK(fault({4, std::vector<double>(6, kUnknown)}) ==
          "expected ratings that differ, got the same for every rated pair");
}

TEST_CASE("evaluation: the same bits on any number of threads") {
    const Dissimilarity people = of_random_points(9, 6);
    const Dissimilarity metric = disturbed(people, 0.8);
    EvaluationParams one = quick();
    one.threads = 1;
    EvaluationParams three = quick();
    three.threads = 3;
    const Evaluation a = evaluate(metric, *rated_set(people, one), one);
    const Evaluation b = evaluate(metric, *rated_set(people, three), three);
    CHECK(a.rho_interval.low == b.rho_interval.low);
    CHECK(a.rho_p == b.rho_p);
    CHECK(a.k == b.k);
    CHECK(a.k_spread.high == b.k_spread.high);
    CHECK(a.k_p == b.k_p);
    CHECK(a.k_corrected == b.k_corrected);
}

TEST_CASE("means over sets: in the paper's books what fails counts, in plain ones it is left out") {
    const std::vector<Agreement> three{{0.6, 0.2}, {-0.3, kUnknown}, {kUnknown, 0.5}};
    const MeanAgreement plain = mean_agreement(three, Bookkeeping::plain);
    CHECK(std::abs(plain.signed_rho - 0.15) <= 1e-15);
    CHECK(std::abs(plain.absolute_rho - 0.45) <= 1e-15);
    CHECK(std::abs(plain.k - 0.35) <= 1e-15);
    CHECK(plain.sets == 3);
    CHECK(plain.undefined_rho == 1);
    CHECK(plain.failed_maps == 1);
    const MeanAgreement paper = mean_agreement(three, Bookkeeping::paper);
    CHECK(std::abs(paper.absolute_rho - 0.3) <= 1e-15);
    CHECK(std::abs(paper.signed_rho - 0.1) <= 1e-15);
    CHECK(std::abs(paper.k - 1.7 / 3.0) <= 1e-15);
    CHECK(std::isnan(mean_agreement({}, Bookkeeping::plain).k));
    CHECK(std::isnan(mean_agreement({}, Bookkeeping::paper).k));
}

TEST_CASE("means over sets: the averages printed in Table 2 are those of the paper's books") {
    const Table2 table = table2();
    REQUIRE(table.head.size() == 19);
    const std::map<std::string, std::set<std::string>> cases{
        {"AVERAGE_6_trained", {"trained"}},
        {"AVERAGE_6_untrained", {"untrained"}},
        {"AVERAGE_12", {"trained", "untrained"}}};
    int averages = 0;
    for (const auto& row : table.rows) {
        if (!row[1].starts_with("AVERAGE")) continue;
        ++averages;
        for (std::size_t column = 5; column < 19; column += 2) {
            CAPTURE(row[1]);
            CAPTURE(table.head[column]);
            std::vector<Agreement> agreements;
            for (const auto& set : table.rows) {
                if (set[1].starts_with("AVERAGE") || !cases.at(row[1]).contains(set[0])) continue;
                agreements.push_back({printed(set[column]).value_or(kUnknown),
                                      printed(set[column + 1]).value_or(kUnknown)});
            }
            const MeanAgreement mean = mean_agreement(agreements, Bookkeeping::paper);
            constexpr double kHalfOfLastDigit = 0.005 + 1e-9;
            CHECK(std::abs(mean.absolute_rho - *printed(row[column])) <= kHalfOfLastDigit);
            CHECK(std::abs(mean.k - *printed(row[column + 1])) <= kHalfOfLastDigit);
        }
    }
    CHECK(averages == 3);
}

// Recomputed by another program from the same printed cells.
TEST_CASE("means over sets: with their signs, the rivals' averages of Table 2 are lower") {
    const Table2 table = table2();
    const std::vector<double> expected{.672, .428, .416, .506, .510, .401, .434};
    for (std::size_t metric = 0; metric < 7; ++metric) {
        std::vector<Agreement> agreements;
        for (const auto& set : table.rows) {
            if (set[1].starts_with("AVERAGE")) continue;
            agreements.push_back({printed(set[5 + 2 * metric]).value_or(kUnknown), 0.5});
        }
        REQUIRE(agreements.size() == 12);
        const MeanAgreement paper = mean_agreement(agreements, Bookkeeping::paper);
        CHECK(std::abs(paper.signed_rho - expected[metric]) <= 0.0005 + 1e-9);
        CHECK(paper.signed_rho <= paper.absolute_rho + 1e-15);
        const MeanAgreement plain = mean_agreement(agreements, Bookkeeping::plain);
        const bool is_mtm = table.head[5 + 2 * metric] == "Mtm_rho";
        CHECK(plain.undefined_rho == (is_mtm ? 1 : 0));
        CHECK((plain.signed_rho == paper.signed_rho) == !is_mtm);
    }
}

TEST_CASE("evaluation: patterns without ratings have no say, wherever they stand in the set") {
    const Dissimilarity metric = of_random_points(7, 3);
    const Dissimilarity people = disturbed(metric, 0.3);
    const std::vector<std::size_t> kept{0, 2, 3, 4, 6};
    Dissimilarity some{7, std::vector<double>(pair_count(7), kUnknown)};
    Dissimilarity part{5, {}};
    Dissimilarity part_metric{5, {}};
    for (std::size_t i = 0; i < kept.size(); ++i) {
        for (std::size_t j = i + 1; j < kept.size(); ++j) {
            some.condensed[pair_index(7, kept[i], kept[j])] = people(kept[i], kept[j]);
            part.condensed.push_back(people(kept[i], kept[j]));
            part_metric.condensed.push_back(metric(kept[i], kept[j]));
        }
    }
    const RatedSet rated_some = rated(some);
    CHECK(rated_some.rated == kept);
    CHECK(rated_part(rated_some).people.dissimilarity == part);
    const Evaluation whole = evaluate(metric, rated_some, quick());
    const Evaluation alone = evaluate(part_metric, rated(part), quick());
    CHECK(whole.rho == alone.rho);
    CHECK(whole.rho_interval.low == alone.rho_interval.low);
    CHECK(whole.rho_p == alone.rho_p);
    CHECK(whole.k == alone.k);
    CHECK(whole.k_p == alone.k_p);
    CHECK(whole.k_corrected == alone.k_corrected);
    Dissimilarity two{4, {0.3, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown}};
    CHECK(rated_set(two, quick()).error().message ==
          "expected ratings of at least three patterns, got 2");
}

}  // namespace evaluation_test
