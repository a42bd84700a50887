#include "model/map/alienation.h"

#include <cmath>

#include "model/common/random.h"
#include "model/map/isotonic.h"
#include "model/map/smacof.h"
#include "tests/support/golden.h"

namespace alienation_tests {

using namespace tact;
using Eigen::MatrixXd;
using golden::Json;

namespace {

// Square roots of differences of numbers near 1 lose half their digits.
constexpr double kRootRounding = 1e-7;

MatrixXd random_map(Eigen::Index n, Eigen::Index k, std::uint64_t seed) {
    RandomStream random{seed};
    MatrixXd points(n, k);
    for (Eigen::Index e = 0; e < points.size(); ++e) points.data()[e] = next_normal(random);
    return points;
}

}  // namespace

TEST_CASE("alienation: of the rectangle in smacof's help, and of a corner and a square") {
    MatrixXd x(4, 2);
    MatrixXd y(4, 2);
    x << 1, 2, -1, 2, -1, -2, 1, -2;
    y << .07, 2.62, .93, 3.12, 1.93, 1.38, 1.07, .88;
    CHECK(std::abs(*alienation(x, y) - 0.00282173203932) <= 1e-12);  // printed from 1 - c^2
    CHECK(std::abs(*alienation_procrustes(x, y) - 0.00399313769970) <= 1e-12);

    MatrixXd corner(4, 3);
    MatrixXd square(4, 2);
    corner << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    square << 0, 0, 1, 0, 0, 1, 1, 1;
    const double k = *alienation(corner, square);
    CHECK(std::abs(k - 0.237430530864811) <= 1e-15);
    CHECK(std::abs(std::sqrt(1.0 - k * k) - 0.971404520791032) <= 1e-15);
    CHECK(std::abs(*alienation_procrustes(corner, square) - 0.593630344692143) <= 1e-14);
}

TEST_CASE("PROTEST: of all orders of the points those that fit as well are another program's") {
    for (const Json& json : golden::read("metric_statistics.json", "protest")) {
        CAPTURE(json.at("name").get<std::string>());
        const MatrixXd a = golden::matrix_of(json.at("a"));
        const MatrixXd b = golden::matrix_of(json.at("b"));
        const auto test = protest(a, b, {});
        REQUIRE(test);
        CHECK(test->is_exact);
        CHECK(test->as_good == json.at("as_good").get<std::size_t>());
        const double k = *alienation_procrustes(a, b);
        CHECK(std::abs(k * k - json.at("m2").get<double>()) <= 1e-13);
    }
}

TEST_CASE("PROTEST: of many points drawn orders, the same for any number of threads") {
    const MatrixXd a = random_map(12, 3, 1);
    const MatrixXd near = a + 0.3 * random_map(12, 3, 2);
    const auto one = protest(a, near, {500, 6, 1});
    REQUIRE(one);
    CHECK(one->as_good == 0);
    CHECK(one->p == 1.0 / 501.0);
    const MatrixXd far = random_map(12, 2, 4);
    CHECK(protest(a, far, {500, 6, 1})->as_good == protest(a, far, {500, 6, 3})->as_good);
    CHECK(protest(a, far, {500, 6, 1})->p > 0.01);
    CHECK_FALSE(protest(a, MatrixXd::Zero(12, 3), {}));
}

TEST_CASE("alienation: K, K of Procrustes and its permutations are those of another program") {
    const Json table = golden::read("evaluation.json");
    for (const Json& json : table.at("maps")) {
        CAPTURE(json.at("name").get<std::string>());
        const MatrixXd a = golden::matrix_of(json.at("a"));
        const MatrixXd b = golden::matrix_of(json.at("b"));
        CHECK(std::abs(*alienation(a, b) - json.at("k").get<double>()) <= 1e-14);
        CHECK(std::abs(*alienation_procrustes(a, b) - json.at("k_procrustes").get<double>()) <=
              1e-13);
        const auto test = alienation_test(a, b, {});
        REQUIRE(test);
        CHECK(test->is_exact);
        CHECK(test->as_good == json.at("as_good").get<std::size_t>());
        CHECK(test->orders == json.at("orders").get<std::size_t>());
    }
}

TEST_CASE("alienation: turned, mirrored, shifted and scaled, a map is the same shape") {
    const MatrixXd x = random_map(9, 3, 1);
    MatrixXd turn(3, 3);
    turn << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, -1;
    MatrixXd moved = 2.5 * x * turn;
    moved.rowwise() += Eigen::RowVector3d(7, 7, 7);
    CHECK(*alienation(x, moved) <= 1e-14);
    CHECK(*alienation_procrustes(x, moved) <= kRootRounding);
    CHECK(*alienation(1e-200 * x, moved) <= 1e-14);
    const MatrixXd y = random_map(9, 3, 2);
    CHECK(std::abs(*alienation(moved, y) - *alienation(x, y)) <= 1e-14);
    CHECK(std::abs(*alienation(y, x) - *alienation(x, y)) <= 1e-15);
}

TEST_CASE("alienation: of the same points under other names, none of many orders is as good") {
    const MatrixXd x = random_map(12, 3, 3);
    const auto same = alienation_test(x, x, {5000, 1, 0});
    CHECK(same->as_good == 0);
    CHECK(same->p == 1.0 / 5001.0);
    const auto one = alienation_test(x, random_map(12, 3, 4), {500, 1, 1});
    const auto three = alienation_test(x, random_map(12, 3, 4), {500, 1, 3});
    CHECK(one->as_good == three->as_good);
    CHECK(one->p > 1.0 / 501.0);
}

TEST_CASE("alienation: what has no shape is refused") {
    const MatrixXd x = random_map(5, 3, 5);
    const auto fault = [](const Expected<double>& answer) {
        REQUIRE_FALSE(answer);
        return answer.error().message;
    };
    CHECK(fault(alienation(x.topRows(2), x.topRows(2))) ==
          "alienation: expected at least three points, got 2");
    CHECK(fault(alienation(x, x.topRows(4))) ==
          "alienation: expected maps of equally many points, got 5 and 4");
    CHECK(fault(alienation(x, MatrixXd::Constant(5, 3, 0.1))) ==
          "alienation: expected points that differ, got all on one spot");
    MatrixXd holed = x;
    holed(2, 1) = std::nan("");
    CHECK(fault(alienation(holed, x)) == "alienation: expected finite coordinates");
    CHECK_FALSE(alienation_procrustes(x, MatrixXd::Zero(5, 3)));
    CHECK_FALSE(alienation_test(x, MatrixXd::Zero(5, 3), {}));
}

TEST_CASE("alienation of fit: the misfit that is left at the best size") {
    const Dissimilarity delta{5, {5, 3, 4, 1, 2, 6, 2, 5, 4, 1}};
    const std::vector<double> d = distances(random_map(5, 2, 6));
    const std::vector<double> fitted = disparities(delta.condensed, d);
    // 1 - mu^2 = min over b of |dhat - b d|^2 / |dhat|^2
    double dd = 0.0;
    double df = 0.0;
    double ff = 0.0;
    for (std::size_t p = 0; p < d.size(); ++p) {
        dd += d[p] * d[p];
        df += d[p] * fitted[p];
        ff += fitted[p] * fitted[p];
    }
    const double b = df / dd;
    double least = 0.0;
    for (std::size_t p = 0; p < d.size(); ++p) least += std::pow(fitted[p] - b * d[p], 2);
    CHECK(std::abs(alienation_of_fit(d, fitted) - std::sqrt(least / ff)) <= 1e-14);
    CHECK(alienation_of_fit(d, d) <= 1e-15);
    std::vector<double> gap = d;
    gap[3] = std::nan("");
    CHECK(alienation_of_fit(d, gap) <= 1e-15);
    CHECK(alienation_of_fit({}, {}) == 0.0);
}

TEST_CASE("alienation: unrelated maps in space have K of about a half, not 1") {
    struct Printed {
        std::size_t points;
        double mean, low;
    };
    for (const Printed& printed :
         {Printed{7, .479, .358}, Printed{8, .490, .377}, Printed{12, .503, .421},
          Printed{14, .507, .433}, Printed{15, .510, .440}}) {
        CAPTURE(printed.points);
        const AlienationChance chance = chance_alienation(printed.points, 3);
        // Both sides are draws; a mean of 10,000 scatters by .0007, the quantile by .0015.
        CHECK(std::abs(chance.mean - printed.mean) <= 0.003);
        CHECK(std::abs(chance.middle.low - printed.low) <= 0.006);
        CHECK(std::abs(chance.middle.high - 0.60) <= 0.035);
    }
    CHECK(chance_alienation(8, 3, {500, 3, 1}).mean == chance_alienation(8, 3, {500, 3, 3}).mean);
    CHECK(chance_alienation(2, 3).mean == 0.0);
}

TEST_CASE("alienation: corrected for chance, unrelated maps score 0 and one shape 1") {
    const AlienationChance chance = chance_alienation(12, 3);
    CHECK(corrected_alienation(0.0, chance) == 1.0);
    CHECK(corrected_alienation(chance.mean, chance) == 0.0);
    CHECK(corrected_alienation(0.9, chance) < 0.0);
    CHECK(corrected_alienation(0.3, {}) == 0.0);
}

}  // namespace alienation_tests
