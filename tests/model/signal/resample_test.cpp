#include "model/signal/resample.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace resample_test {

using namespace tact;

namespace {

Waveform sine(double frequency_hz, double rate_hz, std::size_t samples) {
    Waveform waveform{rate_hz, std::vector<double>(samples)};
    for (std::size_t n = 0; n < samples; ++n) {
        waveform.samples_g[n] =
            std::sin(2.0 * std::numbers::pi * frequency_hz * static_cast<double>(n) / rate_hz);
    }
    return waveform;
}

// Largest difference away from the ends, where a filter sees the silence beyond.
double middle_difference(const Waveform& a, const Waveform& b) {
    REQUIRE(a.samples_g.size() == b.samples_g.size());
    double largest = 0.0;
    for (std::size_t n = a.samples_g.size() / 10; n < a.samples_g.size() * 9 / 10; ++n) {
        largest = std::max(largest, std::abs(a.samples_g[n] - b.samples_g[n]));
    }
    return largest;
}

}  // namespace

TEST_CASE("resample: a sine of 150 Hz stays the same sine, neither delayed nor scaled") {
    for (const double rate_hz : {11'025.0, 8'000.0, 44'100.0, 48'000.0, 96'000.0}) {
        CAPTURE(rate_hz);
        const Waveform original = sine(150.0, rate_hz, static_cast<std::size_t>(rate_hz));
        const Waveform result = resampled(original, kModelRateHz);
        CHECK(result.rate_hz == kModelRateHz);
        // A difference of 1e-6 of a sine leaves no room for 0.1 % of frequency or amplitude; the
        // recipe promises 28 bits.
        CHECK(middle_difference(result, sine(150.0, kModelRateHz, 10'000)) <= 1e-6);
    }
}

TEST_CASE("resample: there are as many samples as the duration takes, rounded") {
    CHECK(resampled(sine(10.0, 11'025.0, 11'025), 10'000.0).samples_g.size() == 10'000);
    CHECK(resampled(sine(10.0, 11'025.0, 7), 10'000.0).samples_g.size() == 6);
    CHECK(resampled(sine(10.0, 44'100.0, 1), 10'000.0).samples_g.empty());
    CHECK(resampled(sine(10.0, kLowestRateHz, 100), 10'000.0).samples_g.size() == 10'000);
    CHECK(resampled(sine(10.0, kHighestRateHz, 1'000'000), 10'000.0).samples_g.size() == 1000);
    CHECK(resampled({8000.0, {}}, 10'000.0).samples_g.empty());
}

TEST_CASE("resample: the same rate keeps every bit") {
    const Waveform original = sine(333.3, kModelRateHz, 777);
    CHECK(resampled(original, kModelRateHz) == original);
}

TEST_CASE("resample: the extreme rates work both ways") {
    // The filter is hundreds of samples of the lower rate long: its tails still see the ends.
    const Waveform slow = resampled(sine(20.0, kModelRateHz, 100'000), kLowestRateHz);
    CHECK(middle_difference(slow, sine(20.0, kLowestRateHz, 1000)) <= 1e-5);
    const Waveform fast = resampled(sine(2000.0, kModelRateHz, 1000), kHighestRateHz);
    CHECK(middle_difference(fast, sine(2000.0, kHighestRateHz, 1'000'000)) <= 1e-5);
}

}  // namespace resample_test
