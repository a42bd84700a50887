#include "model/evaluation/individuals.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/common/random.h"
#include "tests/support/golden.h"

namespace individual_weights_test {

using namespace tact;
using golden::Json;

namespace {

RatingStudy study_of(std::size_t patterns, const std::vector<std::vector<double>>& ratings) {
    RatingStudy study;
    for (std::size_t k = 0; k < patterns; ++k) study.labels.push_back("p" + std::to_string(k));
    for (std::size_t s = 0; s < ratings.size(); ++s) {
        study.judgements.push_back({"P" + std::to_string(s), ratings[s]});
    }
    return study;
}

// Distances in a common map, of which each weighs the dimensions in their own way.
std::vector<std::vector<double>> weighed(const Eigen::MatrixXd& map,
                                         const std::vector<Eigen::Vector2d>& weights) {
    std::vector<std::vector<double>> ratings;
    for (const Eigen::Vector2d& own : weights) {
        std::vector<double> row;
        for (Eigen::Index i = 0; i < map.rows(); ++i) {
            for (Eigen::Index j = i + 1; j < map.rows(); ++j) {
                const Eigen::VectorXd apart = (map.row(i) - map.row(j)).transpose();
                row.push_back(std::sqrt(apart.cwiseAbs2().dot(own)));
            }
        }
        ratings.push_back(row);
    }
    return ratings;
}

// Nine patterns on a grid whose columns are further apart than its rows.
Eigen::MatrixXd grid() {
    Eigen::MatrixXd map(9, 2);
    for (int k = 0; k < 9; ++k) map.row(k) << 3.0 * (k % 3) + 0.2 * (k % 2), k / 3;
    return map;
}

const std::vector<Eigen::Vector2d> kPeople{{1.0, 1.0}, {1.0, 0.1}, {0.2, 4.0}, {0.0, 1.0}};

}  // namespace

TEST_SUITE("individual weights") {
    TEST_CASE("share explained, weights and common map are SciPy's") {
        for (const Json& one : golden::read("individual_weights.json", "cases")) {
            const std::string name = one["name"];
            CAPTURE(name);
            const auto patterns = one["patterns"].get<std::size_t>();
            const auto ratings = one["ratings"].get<std::vector<std::vector<double>>>();
            const IndividualWeights got =
                individual_weights(study_of(patterns, ratings), one["dimensions"]);
            // It never explains less, whatever is found from other starts.
            CHECK(got.explained == doctest::Approx(one["explained"].get<double>()).epsilon(1e-7));
            REQUIRE(got.people.size() == ratings.size());
            for (std::size_t s = 0; s < got.people.size(); ++s) {
                CAPTURE(s);
                CHECK(std::abs(got.people[s].explained - one["each"][s].get<double>()) < 1e-4);
                const auto weights = one["weights"][s].get<std::vector<double>>();
                CHECK(golden::worst_difference(got.people[s].weights, weights) < 1e-3);
            }
            for (Eigen::Index i = 0; i < got.group.rows(); ++i) {
                for (Eigen::Index r = 0; r < got.group.cols(); ++r) {
                    const double expected =
                        one["group"][static_cast<std::size_t>(i)][static_cast<std::size_t>(r)];
                    CHECK(std::abs(got.group(i, r) - expected) < 1e-3);
                }
            }
        }
    }

    TEST_CASE("people who weigh two dimensions differently are told apart without error") {
        const IndividualWeights got = individual_weights(study_of(9, weighed(grid(), kPeople)), 2);
        REQUIRE(got.people.size() == 4);
        CHECK(got.explained == doctest::Approx(1.0).epsilon(1e-6));
        // Ratios of the weights; columns come by how much all weigh them.
        const Eigen::MatrixXd map = grid().rowwise() - grid().colwise().mean();
        const double sizes = map.col(0).squaredNorm() / map.col(1).squaredNorm();
        const bool columns_first = std::abs(got.people[3].weights[0]) < 1e-4;
        for (std::size_t s = 0; s < 4; ++s) {
            CAPTURE(s);
            const double across = got.people[s].weights[columns_first ? 0 : 1];
            const double along = got.people[s].weights[columns_first ? 1 : 0];
            CHECK(across / along ==
                  doctest::Approx(sizes * kPeople[s](0) / kPeople[s](1)).epsilon(1e-3));
        }
    }

    TEST_CASE("its dimensions are those along which people differ, however the map is turned") {
        // Torgerson's axes of the mean are the start: turned maps must come out straight.
        Eigen::Matrix2d turn;
        turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
        const Eigen::MatrixXd map = grid().rowwise() - grid().colwise().mean();
        // In the turned map people weigh across and along its diagonals.
        const IndividualWeights got =
            individual_weights(study_of(9, weighed(map * turn, kPeople)), 2);
        const Eigen::MatrixXd expected = map * turn;
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            const Eigen::VectorXd column = expected.col(axis).normalized();
            const double first = std::abs(got.group.col(0).dot(column));
            const double second = std::abs(got.group.col(1).dot(column));
            CHECK(std::max(first, second) > 0.9999);
        }
    }

    TEST_CASE("a person's scale has no say") {
        auto ratings = weighed(grid(), kPeople);
        const IndividualWeights before = individual_weights(study_of(9, ratings), 2);
        for (double& one : ratings[1]) one *= 7.0;
        const IndividualWeights after = individual_weights(study_of(9, ratings), 2);
        for (std::size_t s = 0; s < 4; ++s) {
            CHECK(golden::worst_difference(after.people[s].weights, before.people[s].weights) <
                  1e-6);
        }
    }

    TEST_CASE("who left a pair out, or rates all pairs alike, is left out and named") {
        auto ratings = weighed(grid(), kPeople);
        ratings[0][3] = kNoRating;
        ratings[2].assign(ratings[2].size(), 0.0);
        const IndividualWeights got = individual_weights(study_of(9, ratings), 2);
        CHECK(got.left_out == std::vector<std::string>{"P0", "P2"});
        REQUIRE(got.people.size() == 2);
        CHECK(got.people[0].participant == "P1");
    }

    TEST_CASE("patterns that nobody rated are left out, those of the rest stay") {
        const auto ratings = weighed(grid(), kPeople);
        const IndividualWeights all = individual_weights(study_of(9, ratings), 2);
        std::vector<std::vector<double>> wider;
        for (const auto& row : ratings) {
            const Dissimilarity whole{9, row};
            std::vector<double> spread;  // a tenth pattern before all others
            for (std::size_t i = 0; i < 10; ++i) {
                for (std::size_t j = i + 1; j < 10; ++j) {
                    spread.push_back(i == 0 ? kNoRating : whole(i - 1, j - 1));
                }
            }
            wider.push_back(spread);
        }
        const IndividualWeights got = individual_weights(study_of(10, wider), 2);
        CHECK(got.labels.size() == 9);
        CHECK(got.labels.front() == "p1");
        CHECK(got.group == all.group);
    }

    TEST_CASE("of one person, or of too few patterns, nothing is said") {
        auto ratings = weighed(grid(), kPeople);
        ratings.resize(1);
        CHECK(individual_weights(study_of(9, ratings), 2).people.empty());
        const std::vector<std::vector<double>> three{{1, 2, 3}, {3, 2, 1}};
        CHECK(individual_weights(study_of(3, three), 2).people.empty());
        CHECK(individual_weights(study_of(3, three), 1).people.size() == 2);
        CHECK(individual_weights({}, 3).people.empty());
        CHECK(shown_weight_dimensions(12) == 3);
        CHECK(shown_weight_dimensions(4) == 2);
        CHECK(shown_weight_dimensions(2) == 0);
    }

    // The start of the mean alone ends in a worse optimum for some of these studies of noise.
    TEST_CASE("random starts find what the start of the mean misses") {
        int better = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            RandomStream random{random_bits(41, seed)};
            std::vector<std::vector<double>> ratings(4, std::vector<double>(pair_count(7)));
            for (auto& person : ratings) {
                for (double& one : person) one = 1.0 + next_even(random);
            }
            const RatingStudy study = study_of(7, ratings);
            const double alone = individual_weights(study, 3, 0).explained;
            const double searched = individual_weights(study, 3).explained;
            CHECK(searched >= alone);
            if (searched > alone + 1e-4) ++better;
        }
        CHECK(better >= 2);
    }
    TEST_CASE("same ratings, same bits") {
        const RatingStudy study = study_of(9, weighed(grid(), kPeople));
        const IndividualWeights a = individual_weights(study, 2);
        const IndividualWeights b = individual_weights(study, 2);
        CHECK(a.group == b.group);
        CHECK(a.people[2].weights == b.people[2].weights);
    }
}

}  // namespace individual_weights_test
