#include "model/map/mds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/map/procrustes.h"
#include "tests/support/golden.h"
#include "tests/support/made_up_maps.h"

namespace mds_test {

using namespace tact;
using Eigen::MatrixXd;
using golden::Json;

namespace {

struct OracleCase {
    std::string name;
    Dissimilarity dissimilarity;
    MdsParams params;
    MatrixXd start;
    double iso_mds;
    double mono_mds;
};

std::vector<OracleCase> oracle_cases() {
    std::vector<OracleCase> result;
    const Json table = golden::read("mds.json");
    for (const Json& json : table.at("cases")) {
        OracleCase entry;
        entry.name = json.at("name").get<std::string>() + ", dimensions " +
                     std::to_string(json.at("dimensions").get<int>());
        entry.dissimilarity = {json.at("size"), json.at("condensed")};
        entry.params.dimensions = json.at("dimensions");
        entry.start = golden::matrix_of(json.at("start"));
        entry.iso_mds = json.at("isoMDS");
        entry.mono_mds = json.at("monoMDS_best_of_20");
        result.push_back(entry);
    }
    REQUIRE(result.size() >= 10);
    return result;
}

// What a panel may rely on, whatever the input.
void check_drawable(const PerceptualSpace& space, std::size_t n, int dimensions) {
    CHECK(space.points.rows() == static_cast<Eigen::Index>(n));
    CHECK(space.points.cols() == dimensions);
    CHECK(space.points.allFinite());
    CHECK(space.stress1 >= 0.0);
    CHECK(space.stress1 < 1.0);
}

}  // namespace

TEST_CASE("torgerson: the same coordinates as R's cmdscale, up to mirror images") {
    for (const OracleCase& entry : oracle_cases()) {
        CAPTURE(entry.name);
        const MatrixXd points = torgerson(entry.dissimilarity, entry.params.dimensions);
        // Two eigensolvers; coordinates up to 15.
        CHECK((points.cwiseAbs() - entry.start.cwiseAbs()).cwiseAbs().maxCoeff() <= 1e-11);
    }
}

TEST_CASE("torgerson: a rectangle of 3 by 4 has eigenvalues 16, 9, 0") {
    MatrixXd rectangle(4, 2);
    rectangle << 0, 0, 4, 0, 4, 3, 0, 3;
    const MatrixXd points = torgerson(of_points(rectangle), 3);
    CHECK(std::abs(points.col(0).squaredNorm() - 16.0) <= 1e-13);
    CHECK(std::abs(points.col(1).squaredNorm() - 9.0) <= 1e-13);
    CHECK(points.col(2).isZero(0.0));
}

TEST_CASE("torgerson: an unknown pair counts as the mean of the others") {
    Dissimilarity dissimilarity = random_dissimilarity(8, 12);
    double mean = 0.0;
    for (std::size_t p = 0; p < 28; ++p) mean += p == 5 ? 0.0 : dissimilarity.condensed[p] / 27.0;
    dissimilarity.condensed[5] = mean;
    const MatrixXd expected = torgerson(dissimilarity, 3);
    dissimilarity.condensed[5] = std::nan("");
    const MatrixXd points = torgerson(dissimilarity, 3);
    CHECK((points - expected).cwiseAbs().maxCoeff() <= 1e-12 * expected.cwiseAbs().maxCoeff());
}

TEST_CASE("mds: from the classical start, stress is at most that of R's isoMDS") {
    for (const OracleCase& entry : oracle_cases()) {
        CAPTURE(entry.name);
        const PerceptualSpace space = smacof(entry.dissimilarity, entry.start, entry.params);
        CHECK_MESSAGE(space.stress1 <= entry.iso_mds + 1e-6,
                      "above by " << space.stress1 - entry.iso_mds);
    }
}

TEST_CASE("mds: the best start is at most the best of isoMDS and of 20 starts of monoMDS") {
    for (OracleCase entry : oracle_cases()) {
        CAPTURE(entry.name);
        entry.params.random_starts = 40;  // fewer than by default, to be quick under sanitizers
        const PerceptualSpace space = nonmetric_mds(entry.dissimilarity, entry.params);
        const double theirs = std::min(entry.iso_mds, entry.mono_mds);
        CHECK_MESSAGE(space.stress1 <= theirs + 1e-4, "above by " << space.stress1 - theirs);
        CHECK(space.verdict == MdsVerdict::fine);
    }
}

// Best of 200 starts of another SMACOF and of 120 starts of Nelder-Mead.
TEST_CASE("mds: five objects on a line have stress .127317, in the plane 0") {
    const Dissimilarity dissimilarity{5, {5, 3, 4, 1, 2, 6, 2, 5, 4, 1}};
    CHECK(std::abs(nonmetric_mds(dissimilarity, mds_with(1, 200)).stress1 - 0.127317) <= 5e-7);
    CHECK(nonmetric_mds(dissimilarity, mds_with(2, 200)).stress1 <= 1e-6);
}

TEST_CASE("mds: cubed distances of planar points are fitted in the plane") {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        Dissimilarity dissimilarity = of_points(random_map(6, 2, seed));
        for (double& value : dissimilarity.condensed) value = value * value * value;
        CHECK(nonmetric_mds(dissimilarity, mds_with(2, 100)).stress1 < 1e-3);
    }
}

TEST_CASE("mds: the order of all distances brings back the map") {
    const MatrixXd truth = random_map(25, 3, 11);
    Dissimilarity dissimilarity = of_points(truth);
    for (double& value : dissimilarity.condensed) value = std::exp(value);
    const PerceptualSpace space = nonmetric_mds(dissimilarity, mds_with(3, 20));
    CHECK(space.stress1 < 1e-3);
    CHECK(procrustes(space.points, truth).correlation > 0.999);
}

TEST_CASE("mds: up to k + 1 objects any order fits, and is there to be seen") {
    for (const int k : {1, 2, 3, 4}) {
        for (std::size_t n = 2; n <= static_cast<std::size_t>(k) + 1; ++n) {
            CAPTURE(n);
            const Dissimilarity dissimilarity = random_dissimilarity(n, 17);
            const PerceptualSpace space = nonmetric_mds(dissimilarity, mds_with(k, 10));
            check_drawable(space, n, k);
            CHECK(space.verdict == MdsVerdict::trivial);
            CHECK(space.stress1 <= 1e-12);
            CHECK(space.points.norm() > 0.1);
            const std::vector<double> d = distances(space.points);
            for (std::size_t p = 0; p < d.size(); ++p) {
                for (std::size_t q = 0; q < d.size(); ++q) {
                    if (dissimilarity.condensed[p] < dissimilarity.condensed[q]) {
                        CHECK(d[p] <= d[q] + 1e-12);
                    }
                }
            }
        }
    }
}

TEST_CASE("mds: equal dissimilarities make no map") {
    for (const double value : {0.0, 3.0}) {
        Dissimilarity dissimilarity{6, std::vector<double>(15, value)};
        dissimilarity.condensed[4] *= 1.0 + 1e-15;  // rounding noise
        const PerceptualSpace space = nonmetric_mds(dissimilarity, {});
        CHECK(space.verdict == MdsVerdict::constant);
        CHECK(space.points.isZero(0.0));
        CHECK(space.points.rows() == 6);
        CHECK(space.points.cols() == 3);
        CHECK(space.stress1 == 0.0);
    }
    // Two objects that do not differ are one spot, two that do are apart.
    CHECK(nonmetric_mds({2, {0.0}}, {}).verdict == MdsVerdict::constant);
    const PerceptualSpace two = nonmetric_mds({2, {3.0}}, {});
    CHECK(two.verdict == MdsVerdict::trivial);
    CHECK(std::abs(distances(two.points)[0] - 1.0) <= 1e-14);
}

TEST_CASE("mds: fewer than two objects make no map") {
    for (const std::size_t n : {0UL, 1UL}) {
        const PerceptualSpace space = nonmetric_mds({n, {}}, {});
        CHECK(space.verdict == MdsVerdict::too_few);
        CHECK(space.points.rows() == static_cast<Eigen::Index>(n));
        CHECK(space.points.isZero(0.0));
    }
}

TEST_CASE("mds: groups that collapse onto one spot are told") {
    // Two groups of three, every difference within far below every difference between: the fit is
    // perfect once each group is a point, although its pairs differ.
    Dissimilarity dissimilarity{6, {}};
    for (std::size_t p = 0; p < 15; ++p) {
        const auto [i, j] = pair_at(6, p);
        const bool within = (i < 3) == (j < 3);
        dissimilarity.condensed.push_back((within ? 1.0 : 100.0) + 0.01 * static_cast<double>(p));
    }
    const PerceptualSpace space = nonmetric_mds(dissimilarity, mds_with(1, 50));
    check_drawable(space, 6, 1);
    CHECK(space.stress1 < 1e-6);
    CHECK(space.verdict == MdsVerdict::colocated);
    CHECK(fit_label(space) == "degenerate");
    CHECK(remark_on(space).find("6 patterns lie on 2 spots") != std::string::npos);
}

TEST_CASE(
    "mds: no stress near 0 is called perfect where groups all but meet, or patterns are few") {
    // A descent that stops early leaves the two groups above a hair apart from meeting.
    Dissimilarity groups{8, {}};
    for (std::size_t p = 0; p < pair_count(8); ++p) {
        const auto [i, j] = pair_at(8, p);
        groups.condensed.push_back(((i < 4) == (j < 4) ? 1.0 : 100.0) +
                                   0.01 * static_cast<double>(p));
    }
    MatrixXd start(8, 1);
    for (Eigen::Index k = 0; k < 8; ++k)
        start(k, 0) = (k < 4 ? 0.0 : 1.0) + 1e-5 * static_cast<double>(k % 4);
    MdsParams params = mds_with(1, 0);
    params.max_steps = 0;
    const PerceptualSpace near = smacof(groups, start, params);
    CHECK(near.stress1 < 1e-3);
    CHECK(near.verdict == MdsVerdict::fine);
    CHECK(fit_label(near) == "degenerate");
    CHECK(remark_on(near).starts_with("degenerate: groups of patterns have collapsed"));
    // 2k + 1 patterns fit nearly any order; one more that fits is worth a word of praise.
    const PerceptualSpace seven = nonmetric_mds(of_points(random_map(7, 3, 4)), mds_with(3, 10));
    CHECK(seven.stress1 < 1e-3);
    CHECK(fit_label(seven) == "degenerate");
    const PerceptualSpace nine = nonmetric_mds(of_points(random_map(9, 2, 4)), mds_with(2, 10));
    CHECK(fit_label(nine) == "perfect");
    CHECK(remark_on(nine).empty());
    // Equal dissimilarities have no map, and no praise.
    CHECK(fit_label(nonmetric_mds({4, std::vector<double>(6, 1.0)}, {})) == "degenerate");
}

TEST_CASE("mds: the published procedure stops before groups collapse") {
    Dissimilarity groups{6, {}};
    for (std::size_t p = 0; p < 15; ++p) {
        const auto [i, j] = pair_at(6, p);
        groups.condensed.push_back(((i < 3) == (j < 3) ? 1.0 : 3.0) + 0.1 * static_cast<double>(p));
    }
    const PerceptualSpace early = smacof(groups, torgerson(groups, 1), published_mds_params(1));
    const PerceptualSpace best = nonmetric_mds(groups, mds_with(1, 50));
    CHECK(best.collapsed_stress1 < early.stress1);
    CHECK(early.verdict == MdsVerdict::fine);
    CHECK(early.stress1 < 0.2);
}

TEST_CASE("mds: where groups collapse in the best map by order, the map is by size, and says so") {
    Dissimilarity groups{10, {}};
    for (std::size_t p = 0; p < pair_count(10); ++p) {
        const auto [i, j] = pair_at(10, p);
        groups.condensed.push_back(((i < 5) == (j < 5) ? 10.0 : 70.0) +
                                   static_cast<double>((p * 7) % 13));
    }
    for (const int dimensions : {2, 3}) {
        const PerceptualSpace space = nonmetric_mds(groups, mds_with(dimensions, 50));
        check_drawable(space, 10, dimensions);
        CHECK(space.collapsed_stress1 < 1e-3);
        CHECK(space.verdict == MdsVerdict::fine);
        CHECK_FALSE(space.is_degenerate);
        CHECK(space.stress1 > space.collapsed_stress1);
        CHECK(remark_on(space).find("interval scaling") != std::string::npos);
        const std::vector<double> d = distances(space.points);
        const auto [least, most] = std::ranges::minmax(d);
        CHECK(least > 0.02 * most);
        // The groups stay apart: no pair within one is as far as the nearest of both.
        double widest_within = 0.0;
        double nearest_between = most;
        for (std::size_t p = 0; p < d.size(); ++p) {
            const auto [i, j] = pair_at(10, p);
            if ((i < 5) == (j < 5)) {
                widest_within = std::max(widest_within, d[p]);
            } else {
                nearest_between = std::min(nearest_between, d[p]);
            }
        }
        CHECK(widest_within < nearest_between);
    }
    // A map that is not degenerate is not touched.
    const PerceptualSpace plain = nonmetric_mds(random_dissimilarity(10, 31), mds_with(2, 20));
    CHECK(std::isnan(plain.collapsed_stress1));
}

TEST_CASE("mds: interval scaling finds points whose distances are a constant and a multiple") {
    const MatrixXd points = random_map(9, 2, 12);
    Dissimilarity scaled = of_points(points);
    const PairOrder order = order_pairs(scaled.condensed);
    std::vector<double> fitted(scaled.condensed.size(), -1.0);
    std::vector<double> measured = scaled.condensed;
    for (double& value : measured) value = 3.0 + 0.5 * value;
    fit_interval(order, scaled.condensed, measured, fitted);
    for (std::size_t p = 0; p < fitted.size(); ++p)
        CHECK(std::abs(fitted[p] - measured[p]) < 1e-12);
    // Where distances fall, the constant alone; where a line would begin below 0, it begins at 0.
    for (std::size_t p = 0; p < fitted.size(); ++p) measured[p] = 9.0 - scaled.condensed[p];
    fit_interval(order, scaled.condensed, measured, fitted);
    CHECK(*std::ranges::max_element(fitted) - *std::ranges::min_element(fitted) < 1e-12);
    const std::vector<double> three{1.0, 2.0, 3.0};
    const PairOrder of_three = order_pairs(three);
    std::vector<double> line(3);
    fit_interval(of_three, three, std::vector<double>{0.0, 0.0, 3.0}, line);
    CHECK(line[0] == 0.0);
    CHECK(std::abs(line[1] - 1.2) < 1e-12);  // sum of above * d / sum of above^2 = 6 / 5
    CHECK(std::abs(line[2] - 2.4) < 1e-12);
    const Descent end = descend(order, random_map(9, 2, 13), {1e-12, 3000, scaled.condensed});
    const std::vector<double> d = distances(end.points);
    fit_interval(order, scaled.condensed, d, fitted);
    double miss = 0.0;
    double size = 0.0;
    for (std::size_t p = 0; p < d.size(); ++p) {
        miss += (d[p] - fitted[p]) * (d[p] - fitted[p]);
        size += d[p] * d[p];
    }
    CHECK(std::abs(std::sqrt(miss / size) - end.stress1) < 1e-12);
}

TEST_CASE("mds: twins on one spot are right there") {
    MatrixXd points = random_map(9, 2, 20);
    points.row(4) = points.row(1);
    PerceptualSpace space = nonmetric_mds(of_points(points), mds_with(2, 10));
    CHECK(space.stress1 < 1e-6);
    CHECK(space.verdict == MdsVerdict::fine);
    CHECK((space.points.row(4) - space.points.row(1)).norm() < 1e-6);
    points.row(7) = points.row(0);  // two pairs tied for the least
    space = nonmetric_mds(of_points(points), mds_with(2, 10));
    CHECK(space.verdict == MdsVerdict::fine);
    CHECK((space.points.row(7) - space.points.row(0)).norm() < 1e-6);
}

TEST_CASE("mds: names do not matter") {
    const Dissimilarity dissimilarity = random_dissimilarity(9, 21);
    const std::array<std::size_t, 9> order{4, 2, 8, 0, 6, 1, 7, 5, 3};
    Dissimilarity renamed{9, {}};
    for (std::size_t p = 0; p < pair_count(9); ++p) {
        const auto [i, j] = pair_at(9, p);
        renamed.condensed.push_back(dissimilarity(order[i], order[j]));
    }
    const PerceptualSpace a = nonmetric_mds(dissimilarity, {});
    const PerceptualSpace b = nonmetric_mds(renamed, {});
    // The best of 101 other starts: the same valley, to the tolerance of its floor.
    CHECK(std::abs(a.stress1 - b.stress1) <= 1e-7);
    MatrixXd matched(9, 3);
    for (Eigen::Index i = 0; i < 9; ++i) {
        matched.row(static_cast<Eigen::Index>(order[static_cast<std::size_t>(i)])) =
            b.points.row(i);
    }
    CHECK(procrustes(matched, a.points).correlation > 0.9999);
}

TEST_CASE("mds: whatever the dissimilarities, coordinates are numbers") {
    const double unknown = std::nan("");
    const double infinite = std::numeric_limits<double>::infinity();
    for (const std::size_t n : {2UL, 3UL, 5UL, 8UL}) {
        for (const double odd : {unknown, infinite, -infinite, 1e308, -1e308, -3.0, 0.0, 1e-310}) {
            CAPTURE(n);
            CAPTURE(odd);
            Dissimilarity some = random_dissimilarity(n, 27);
            for (std::size_t p = 0; p < some.condensed.size(); p += 2) some.condensed[p] = odd;
            check_drawable(nonmetric_mds(some, mds_with(3, 4)), n, 3);
            const Dissimilarity all{n, std::vector<double>(pair_count(n), odd)};
            check_drawable(nonmetric_mds(all, mds_with(3, 4)), n, 3);
            check_drawable(
                smacof(some, random_map(static_cast<Eigen::Index>(n), 2, 1), mds_with(2, 0)), n, 2);
        }
    }
    // An object nothing is known of.
    Dissimilarity lone = random_dissimilarity(8, 28);
    for (std::size_t j = 1; j < 8; ++j) lone.condensed[pair_index(8, 0, j)] = unknown;
    check_drawable(nonmetric_mds(lone, {}), 8, 3);
}

TEST_CASE("mds: unknown pairs do not count in stress") {
    Dissimilarity dissimilarity = of_points(random_map(12, 2, 29));
    const double before = nonmetric_mds(dissimilarity, mds_with(2, 20)).stress1;
    dissimilarity.condensed[7] = 1e3;
    CHECK(nonmetric_mds(dissimilarity, mds_with(2, 20)).stress1 > 0.01);
    dissimilarity.condensed[7] = std::nan("");
    CHECK(nonmetric_mds(dissimilarity, mds_with(2, 20)).stress1 < 1e-3);
    CHECK(before < 1e-3);
}

TEST_CASE("mds: stopped, it returns the best so far and says so") {
    const Dissimilarity dissimilarity = random_dissimilarity(10, 31);
    std::stop_source before;
    before.request_stop();
    const PerceptualSpace none = nonmetric_mds(dissimilarity, {}, before.get_token());
    CHECK(none.stopped);
    CHECK(none.start_stress.size() == 1);
    check_drawable(none, 10, 3);
    CHECK(none.points.norm() > 0.1);

    MdsParams params;
    params.threads = 1;
    std::stop_source midway;
    const PerceptualSpace some =
        nonmetric_mds(dissimilarity, params, midway.get_token(), [&midway](std::size_t done) {
            if (done == 5) midway.request_stop();
        });
    CHECK(some.stopped);
    CHECK(some.start_stress.size() == 5);
    CHECK_FALSE(nonmetric_mds(dissimilarity, params).stopped);
}

TEST_CASE("mds: different objects closer than a millionth of the map are on one spot") {
    // Not moved: the verdict is on the present map.
    const Dissimilarity dissimilarity{4, {3.0, 4.0, 5.0, 6.0, 2.0, 1.0}};
    const auto verdict_at = [&](double apart) {
        MatrixXd start(4, 2);
        start << 0.0, 0.0, apart, 0.0, 1.0, 0.0, 0.0, 0.6;
        MdsParams params = mds_with(2, 0);
        params.max_steps = 0;
        return smacof(dissimilarity, start, params).verdict;
    };
    CHECK(verdict_at(5e-7) == MdsVerdict::colocated);
    CHECK(verdict_at(1e-8) == MdsVerdict::colocated);
    CHECK(verdict_at(3e-6) == MdsVerdict::fine);
}

TEST_CASE("mds: products are cut into the same blocks on every processor") {
    CHECK(Eigen::l1CacheSize() == kBlockCacheBytes[0]);
    CHECK(Eigen::l2CacheSize() == kBlockCacheBytes[1]);
    CHECK(Eigen::l3CacheSize() == kBlockCacheBytes[2]);
}

}  // namespace mds_test
