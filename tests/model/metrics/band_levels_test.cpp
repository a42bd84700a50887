#include "model/metrics/band_levels.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace band_levels_test {

using namespace tact;

namespace {

BandLevels levels_of(double f_hz, double amplitude_g) {
    const Waveform waveform = tone(f_hz, kModelRateHz, 10'000, amplitude_g);
    return band_levels_db(amplitude_spectrum(waveform.samples_g, kModelRateHz), default_tables());
}

}  // namespace

TEST_CASE(
    "band levels: a tone is as far above threshold in its band as the receptors' curve says") {
    // 250 Hz: 1 g is 3.975 um; the Pacinian threshold, the lowest there, is 0.1 um.
    const auto levels = levels_of(250.0, 1.0);
    const double over_db = 20.0 * std::log10(displacement_um(1.0, 250.0) / 0.1);
    const auto expected_band =
        static_cast<std::size_t>(9.0 * std::log(250.0 / 5.0) / std::log(200.0));
    for (std::size_t b = 0; b < kBandCount; ++b) {
        CHECK(std::abs(levels[b] - (b == expected_band ? over_db : 0.0)) <= 1e-9);
    }
}

TEST_CASE("band levels: what nobody feels is nothing, and ten times the amplitude 20 dB") {
    CHECK(levels_of(20.0, 1e-4) == BandLevels{});
    CHECK(levels_of(2.0, 1.0) == BandLevels{});  // below all bands, to rounding
    CHECK(std::abs(band_distance(levels_of(70.0, 1.0), levels_of(70.0, 10.0)) - 20.0) <= 1e-9);
    CHECK(band_distance(levels_of(70.0, 1.0), levels_of(70.0, 1.0)) == 0.0);
}

TEST_CASE("band levels: every frequency of 5 to 1000 Hz is in one band, ends included") {
    for (const double f_hz : {5.0, 9.0, 10.0, 50.0, 500.0, 1000.0}) {
        const auto levels = levels_of(f_hz, 40.0);
        CHECK(std::ranges::count_if(levels, [](double level) { return level > 0.0; }) == 1);
    }
    CHECK(levels_of(1001.0, 1.0) == BandLevels{});
}

}  // namespace band_levels_test
