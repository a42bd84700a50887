#include "model/signal/pink_noise.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/signal/spectrum.h"

namespace pink_noise_test {

using namespace tact;

TEST_CASE("pink noise: every octave has as much power") {
    const double rate_hz = 48'000.0;
    const std::vector<double> noise = pink_noise(rate_hz, 8.0, 5);
    REQUIRE(noise.size() == 384'000);
    const Spectrum spectrum = amplitude_spectrum(noise, rate_hz);
    std::vector<double> level_db;
    for (double low_hz = 40.0; low_hz < 10'000.0; low_hz *= 2.0) {
        double power = 0.0;
        for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
            const double hz = frequency_hz(spectrum, k);
            if (hz >= low_hz && hz < 2.0 * low_hz) power += std::pow(spectrum.amplitude_g[k], 2.0);
        }
        level_db.push_back(10.0 * std::log10(power));
    }
    const auto [low, high] = std::ranges::minmax(level_db);
    CHECK(high - low < 1.5);  // 320 bins in the lowest octave: 0.5 dB of chance at two sigma
}

TEST_CASE("pink noise: it fills the scale, has no seam, and is its seed's") {
    const std::vector<double> noise = pink_noise(8000.0, 2.0, 1);
    double largest = 0.0;
    double step = 0.0;
    for (std::size_t k = 0; k < noise.size(); ++k) {
        largest = std::max(largest, std::abs(noise[k]));
        if (k > 0) step = std::max(step, std::abs(noise[k] - noise[k - 1]));
    }
    CHECK(largest == 1.0);
    CHECK(std::abs(noise.front() - noise.back()) <= step);
    CHECK(noise == pink_noise(8000.0, 2.0, 1));
    CHECK(noise != pink_noise(8000.0, 2.0, 2));
    CHECK(pink_noise(8000.0, 0.0, 1).empty());
}

}  // namespace pink_noise_test
