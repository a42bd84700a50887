#include "model/signal/alignment.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/support/temporary_folder.h"

namespace alignment_test {

using namespace tact;

namespace {

Waveform burst(double amplitude_g) {
    Waveform waveform{10'000.0, std::vector<double>(2000, 0.0)};
    for (std::size_t n = 300; n < 1500; ++n) {
        waveform.samples_g[n] =
            amplitude_g * std::sin(2.0 * std::numbers::pi * 0.015 * static_cast<double>(n));
    }
    return waveform;
}

}  // namespace

TEST_CASE("alignment: a recording far from its pattern's strength is said, whichever its sign") {
    const Waveform intended = burst(0.8);
    for (const double factor : {0.41, -0.41, 2.5}) {
        const Alignment alignment = aligned(burst(0.8 * factor), intended);
        CHECK(std::abs(alignment.gain_db - 20.0 * std::log10(std::abs(factor))) <= 1e-9);
        REQUIRE(remarks_on(alignment).size() == 1);
        CHECK(contains(remarks_on(alignment)[0],
                       factor > 1.0 ? "8.0 dB stronger than its pattern" : "7.7 dB weaker than"));
    }
    for (const double factor : {0.72, 1.0, 1.4}) {  // within 3 dB
        CHECK(remarks_on(aligned(burst(0.8 * factor), intended)).empty());
    }
    // Something else has no gain to speak of.
    CHECK(remarks_on(aligned({10'000.0, std::vector<double>(2000, 0.0)}, intended)).size() == 1);
}

// Half a period on or back a tone is as like itself as here, but for rounding.
TEST_CASE("alignment: of the lags at which a steady tone is itself, the least is taken") {
    for (const double frequency_hz : {50.0, 62.5, 100.0, 125.0, 200.0, 250.0, 400.0, 500.0}) {
        CAPTURE(frequency_hz);
        const auto tone = [frequency_hz](double length_s) {
            Waveform waveform{10'000.0, {}};
            for (double n = 0.0; n < length_s * 10'000.0; n += 1.0) {
                waveform.samples_g.push_back(
                    std::sin(2.0 * std::numbers::pi * frequency_hz * n / 10'000.0 + 0.3));
            }
            return waveform;
        };
        CHECK(aligned(tone(1.0), tone(0.4)).lag == 0);
    }
}

}  // namespace alignment_test
