// Numbers from the design page's worked examples, met by tests/golden/make_metrics.py as well.
#include "model/metrics/spectral_matching.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace spectral_matching_test {

using namespace tact;

namespace {

// 1 s at 1 kHz: a line is 1 Hz.
Spectrum of_tone(double f_hz, double amplitude_g = 1.0) {
    return amplitude_spectrum(tone(f_hz, 1000.0, 1000, amplitude_g).samples_g, 1000.0);
}

double msm(const Spectrum& x, const Spectrum& y, const SpectralMatchingParams& params = {}) {
    return spectral_matching(sub_band_spectrum(x, params), sub_band_spectrum(y, params), params);
}

}  // namespace

TEST_CASE("Msm: the worked examples, and less than plain lines within a tenth") {
    const Spectrum x = of_tone(100.0);
    CHECK(std::abs(msm(x, of_tone(104.0)) - 0.0402015126103682) <= 1e-14);
    CHECK(std::abs(msm(x, of_tone(112.0)) - 0.0630856400442916) <= 1e-14);
    CHECK(std::abs(msm(x, of_tone(200.0)) - 0.0630458995373182) <= 1e-14);
    CHECK(std::abs(msm(x, of_tone(100.0, 0.5)) - 0.0222474604157305) <= 1e-14);
    CHECK(std::abs(msm(x, of_tone(100.0, 0.0)) - 0.044494920831461) <= 1e-14);
    SpectralMatchingParams plain;
    plain.width = 0.0;
    CHECK(std::abs(msm(x, of_tone(104.0), plain) - 0.0632455532) <= 5e-11);
}

TEST_CASE("Msm: a line of 100 Hz is seen from 96 to 105 Hz") {
    const auto bands = sub_band_spectrum(of_tone(100.0));
    REQUIRE(bands.size() == 500);  // 1..500 Hz
    for (std::size_t k = 0; k < bands.size(); ++k) {
        const bool is_near = k + 1 >= 96 && k + 1 <= 105;
        CHECK((bands[k] > 1e-3) == is_near);
    }
    CHECK(std::abs(bands[99] - 0.301511344578) <= 5e-13);
    CHECK(std::abs(bands[95] - 1.0 / 3.0) <= 1e-14);
}

TEST_CASE("Msm: symmetric, 0 from itself, and in proportion to both amplitudes") {
    const auto noisy = [](std::uint32_t seed, double amplitude_g) {
        return amplitude_spectrum(golden::noise(seed, 2000, amplitude_g).samples_g, 10'000.0);
    };
    const Spectrum x = noisy(1, 1.0);
    const Spectrum y = noisy(2, 1.0);
    CHECK(msm(x, x) == 0.0);
    CHECK(msm(x, y) == msm(y, x));
    CHECK(std::abs(msm(noisy(1, 4.0), noisy(2, 4.0)) - 4.0 * msm(x, y)) <= 1e-15);
}

TEST_CASE("Msm: normalised, what has nothing in common is sqrt 2 apart, however strong") {
    SpectralMatchingParams params;
    params.is_normalised = true;
    params.width = 0.0;  // windows of unlike widths would overlap or differ in energy
    for (const double strength : {0.1, 1.0, 10.0}) {
        const double apart = msm(of_tone(50.0, strength), of_tone(200.0, strength), params);
        CHECK(std::abs(apart - std::sqrt(2.0)) <= 1e-12);
    }
    const Spectrum silence = of_tone(100.0, 0.0);
    CHECK(msm(silence, silence, params) == 0.0);
    CHECK(std::abs(msm(silence, of_tone(70.0), params) - std::sqrt(2.0)) <= 1e-12);
}

TEST_CASE("Msm: no lines in the band, no difference") {
    SpectralMatchingParams params;
    params.low_hz = 600.0;
    CHECK(sub_band_spectrum(of_tone(100.0), params).empty());
    CHECK(msm(of_tone(100.0), of_tone(200.0), params) == 0.0);
    CHECK(msm({}, {}) == 0.0);
}

}  // namespace spectral_matching_test
