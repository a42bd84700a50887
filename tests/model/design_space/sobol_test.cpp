#include "model/design_space/sobol.h"

#include <algorithm>
#include <vector>

#include "tests/support/golden.h"

namespace sobol_test {

using namespace tact;

TEST_CASE("sobol: points are those of SciPy, bit for bit") {
    const golden::Json points = golden::read("design.json").at("sobol");
    for (const auto& [place, expected] : points.items()) {
        const auto point = static_cast<std::uint32_t>(std::stoul(place));
        for (std::size_t d = 0; d < kSobolDimensions; ++d) {
            CHECK_MESSAGE(sobol_coordinate(point, d) == expected.at(d).get<double>(),
                          "point " << place << ", dimension " << d);
        }
    }
}

TEST_CASE("sobol: the first points are those of the literature") {
    // Bratley & Fox 1988, in the order of Antonov & Saleev.
    const double expected[][2] = {{0, 0},         {0.5, 0.5},     {0.75, 0.25},   {0.25, 0.75},
                                  {0.375, 0.375}, {0.875, 0.875}, {0.625, 0.125}, {0.125, 0.625}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        CHECK(sobol_coordinate(k, 0) == expected[k][0]);
        CHECK(sobol_coordinate(k, 1) == expected[k][1]);
    }
}

TEST_CASE("sobol: of 2^k points each lies in its own 2^-k of every axis, shifted or not") {
    constexpr std::size_t kPoints = 256;
    for (const std::uint32_t shift : {0U, 0xdeadbeefU}) {
        for (std::size_t d = 0; d < kSobolDimensions; ++d) {
            std::vector<int> hits(kPoints, 0);
            for (std::uint32_t k = 0; k < kPoints; ++k) {
                const double at = sobol_coordinate(k, d, shift);
                REQUIRE(at >= 0.0);
                REQUIRE(at < 1.0);
                ++hits[static_cast<std::size_t>(at * kPoints)];
            }
            CHECK(std::ranges::count(hits, 1) == kPoints);
        }
    }
}

}  // namespace sobol_test
