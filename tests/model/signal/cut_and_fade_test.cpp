#include "model/signal/waveform.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace cut_and_fade_test {

using namespace tact;

namespace {

Waveform ones(std::size_t samples) { return {1000.0, std::vector<double>(samples, 1.0)}; }

}  // namespace

TEST_CASE("gain: every sample is multiplied, and the rate stays") {
    const Waveform louder = with_gain({48'000.0, {1.0, -0.5, 0.0}}, -2.0);
    CHECK(louder == Waveform{48'000.0, {-2.0, 1.0, 0.0}});
}

TEST_CASE("trim: the samples from the one time up to the other, and never beyond the ends") {
    const Waveform whole{10.0, {0.0, 1.0, 2.0, 3.0, 4.0}};
    CHECK(part_of(whole, 0.1, 0.3).samples_g == std::vector<double>{1.0, 2.0});
    CHECK(part_of(whole, 0.0, 0.5) == whole);
    CHECK(part_of(whole, -1.0, 9.0) == whole);
    CHECK(part_of(whole, 0.3, 0.3).samples_g.empty());
    CHECK(part_of(whole, 0.4, 0.2).samples_g.empty());
    CHECK(part_of(whole, std::nan(""), 0.2).samples_g.empty());
    CHECK(part_of({10.0, {}}, 0.0, 1.0).samples_g.empty());
}

TEST_CASE("fades: halves of a raised cosine, mirror images, and 1 between them") {
    const auto samples = faded(ones(100), 0.02, 0.04).samples_g;
    CHECK(samples[0] == 0.0);
    CHECK(std::abs(samples[5] - 0.5 * (1.0 - std::sqrt(0.5))) <= 1e-12);
    CHECK(std::abs(samples[10] - 0.5) <= 1e-12);
    for (std::size_t n = 20; n <= 60; ++n) CHECK(samples[n] == 1.0);
    CHECK(std::abs(samples[80] - 0.5) <= 1e-12);
    CHECK(samples[99] > 0.0);
    CHECK(samples[99] < 0.01);
    const auto even = faded(ones(100), 0.03, 0.03).samples_g;
    for (std::size_t n = 1; n < 100; ++n) CHECK(std::abs(even[n] - even[100 - n]) <= 1e-12);
}

TEST_CASE("fades: none leaves the same bits, and longer ones than the waveform meet") {
    const Waveform plain{1000.0, {0.3, -0.7, 0.1}};
    CHECK(faded(plain, 0.0, 0.0) == plain);
    const auto met = faded(ones(10), 1.0, 1.0).samples_g;
    for (const double sample : met) {
        CHECK(sample >= 0.0);
        CHECK(sample < 0.01);
    }
}

}  // namespace cut_and_fade_test
