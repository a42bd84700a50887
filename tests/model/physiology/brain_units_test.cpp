#include "model/physiology/brain_units.h"

#include <doctest/doctest.h>

#include "model/physiology/nc_matrix.h"
#include "tests/support/random_code.h"

namespace brain_units_test {

using namespace tact;

TEST_CASE("brain units: the distance has the bits of the one from counted spikes") {
    const PerReceptor<double> weights[] = {{0.2, 0.7, 0.0, 0.5},     {0.1, 0.2, 0.0, 0.3},
                                           {1.0, 1.0, 1.0, 1.0},     {0.125, 0.705, 0.33, 0.999},
                                           {-0.2, 0.7, -0.001, 0.5}, {1000.0, 0.0, 500.0, 0.0}};
    for (const auto& weight : weights) {
        const auto units = weight_units(weight);
        REQUIRE(units);
        for (const std::size_t samples : {0UL, 1UL, 31UL, 32UL, 33UL, 1000UL, 10'000UL}) {
            CAPTURE(samples);
            const NeuralCode a = random_code(samples, 1);
            const NeuralCode b = random_code(samples, 2);
            const BrainUnits in_units = brain_units(a, *units);
            CHECK(nc_dissimilarity(in_units, brain_units(b, *units), *units) ==
                  nc_dissimilarity(a, b, weight));
            CHECK(nc_dissimilarity(in_units, in_units, *units) == 0.0);
        }
    }
}

TEST_CASE("brain units: silence behind the last spike is not kept, and changes no distance") {
    const PerReceptor<double> weight{0.2, 0.7, 0.0, 0.5};
    const auto units = weight_units(weight);
    REQUIRE(units);
    NeuralCode brief = random_code(1000, 1);
    NeuralCode longer = random_code(2000, 2);
    NeuralCode silent;
    for (NeuralCode* code : {&brief, &longer, &silent}) code->samples = 30'000;
    CHECK(brain_units(brief, *units).values.size() <= 1024);
    CHECK(brain_units(silent, *units).values.empty());
    for (const NeuralCode* a : {&brief, &longer, &silent}) {
        for (const NeuralCode* b : {&brief, &longer, &silent}) {
            CHECK(nc_dissimilarity(brain_units(*a, *units), brain_units(*b, *units), *units) ==
                  nc_dissimilarity(*a, *b, weight));
        }
    }
}

TEST_CASE("brain units: weights that are multiples of nothing have none") {
    CHECK_FALSE(weight_units({0.2, 1.0 / 3.0, 0.0, 0.5}));
    CHECK_FALSE(weight_units({0.2, 0.70001, 0.0, 0.5}));
    CHECK(weight_units({0.0, 0.0, 0.0, 0.0}));
}

TEST_CASE("brain units: the largest products there are fit, on every instruction set") {
    // All channels at every sample, with the largest weights that fit.
    const auto units = weight_units({1.0, 1.001, 0.999, 1.0});
    REQUIRE(units);
    NeuralCode code;
    code.samples = 600'000;  // a minute
    code.central_spikes.assign(code.samples, 15);
    const BrainUnits brain = brain_units(code, *units);
    CHECK(brain.square == 600'000LL * 4000 * 4000);
    for (const ProductSummer& summer : product_summers()) {
        CAPTURE(summer.name);
        CHECK(summer.sum(brain.values, brain.values, units->summed) == brain.square);
    }
}

TEST_CASE("brain units: every instruction set sums alike") {
    const auto units = weight_units({0.2, 0.7, 0.0, 0.5});
    const BrainUnits a = brain_units(random_code(9999, 3), *units);
    const BrainUnits b = brain_units(random_code(9999, 4), *units);
    const auto summers = product_summers();
    REQUIRE(std::string(summers.back().name) == "baseline");
    const std::int64_t expected = summers.back().sum(a.values, b.values, units->summed);
    CHECK(expected > 10'000);
    for (const ProductSummer& summer : summers) {
        CAPTURE(summer.name);
        CHECK(summer.sum(a.values, b.values, units->summed) == expected);
    }
}

}  // namespace brain_units_test
