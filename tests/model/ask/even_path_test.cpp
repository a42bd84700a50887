#include "model/ask/even_path.h"

#include <doctest/doctest.h>

#include <cmath>

namespace even_path_test {

using namespace tact;

namespace {

std::vector<std::vector<double>> grid(std::size_t layers, int parts) {
    std::vector<double> all;
    for (int k = 0; k <= parts; ++k) all.push_back(k / double(parts));
    std::vector<std::vector<double>> result(layers, all);
    result.front() = {0.0};
    result.back() = {1.0};
    return result;
}

}  // namespace

TEST_CASE("even path: on a straight line the steps are even parts") {
    const auto layers = grid(5, 16);
    const EvenPath way = even_path(
        layers,
        [&](std::size_t l, std::size_t i, std::size_t j) {
            return layers[l + 1][j] - layers[l][i];
        },
        0.01);
    REQUIRE(way.chosen.size() == 5);
    CHECK(way.ratio <= 1.01);
    for (std::size_t k = 0; k < 5; ++k)
        CHECK(layers[k][way.chosen[k]] == static_cast<double>(k) / 4.0);
}

TEST_CASE("even path: where distances grow along the way, steps shrink") {
    const auto layers = grid(3, 64);
    const EvenPath way = even_path(
        layers,
        [&](std::size_t l, std::size_t i, std::size_t j) {
            return std::pow(layers[l + 1][j], 2) - std::pow(layers[l][i], 2);
        },
        0.02);
    REQUIRE(way.chosen.size() == 3);
    CHECK(layers[1][way.chosen[1]] == doctest::Approx(std::sqrt(0.5)).epsilon(0.02));
}

TEST_CASE("even path: a jump leaves the least uneven way; without distances there is none") {
    const auto layers = grid(4, 32);
    const auto jumping = [&](std::size_t l, std::size_t i, std::size_t j) {
        const double a = layers[l][i];
        const double b = layers[l + 1][j];
        return b - a + (a < 0.5 && b >= 0.5 ? 10.0 : 0.0);
    };
    const EvenPath way = even_path(layers, jumping, 0.02);
    REQUIRE(way.chosen.size() == 4);
    CHECK(way.ratio > 10.0);
    CHECK(even_path(
              layers, [](std::size_t, std::size_t, std::size_t) { return 0.0; }, 0.02)
              .chosen.empty());
}

TEST_CASE("even path: of ways that are as even, the one whose shares are spread most evenly") {
    const std::vector<std::vector<double>> layers{{0.0}, {0.1, 0.3, 0.5, 0.9}, {1.0}};
    const auto alike = [](std::size_t, std::size_t, std::size_t) { return 1.0; };
    CHECK(even_path(layers, alike, 0.02).chosen == std::vector<std::size_t>{0, 2, 0});
    CHECK(even_path(layers, alike, 0.02).ratio == 1.0);
    // A ratio within the tolerance is told unchanged.
    const auto nearly = [](std::size_t layer, std::size_t, std::size_t) {
        return layer == 0 ? 1.0 : 1.01;
    };
    CHECK(even_path(layers, nearly, 0.02).ratio == doctest::Approx(1.01));
}

}  // namespace even_path_test
