// Numbers from the design page's worked examples, met by tests/golden/make_metrics.py as well.
#include "model/metrics/spectral_rmse.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace spectral_rmse_test {

using namespace tact;

namespace {

constexpr double kPrinted = 1e-14;  // fifteen digits are printed

Spectrum spectrum_of(const Waveform& waveform) {
    return amplitude_spectrum(waveform.samples_g, waveform.rate_hz);
}

double rmse(const Spectrum& x, const Spectrum& y, const SpectralRmseParams& params = {}) {
    return spectral_rmse(compared_lines(x, params), compared_lines(y, params), params);
}

// 16 samples: a line of 1 g at bin 2; half of it and another of 0.25 g, a cosine, at bin 5.
const Waveform kOneLine = tone(2.0, 16.0, 16);

Waveform two_lines() {
    Waveform waveform = kOneLine;
    for (std::size_t n = 0; n < 16; ++n) {
        const double angle = 2.0 * std::numbers::pi * 5.0 * static_cast<double>(n) / 16.0;
        waveform.samples_g[n] = 0.5 * kOneLine.samples_g[n] + 0.25 * std::cos(angle);
    }
    return waveform;
}

}  // namespace

TEST_CASE("spectral RMSE: the worked example, in every form") {
    const Spectrum x = spectrum_of(kOneLine);
    const Spectrum y = spectrum_of(two_lines());
    const Spectrum silence = spectrum_of(Waveform{16.0, std::vector<double>(16, 0.0)});
    CHECK(std::abs(rmse(x, y) - 0.186338998124983) <= kPrinted);
    SpectralRmseParams band;
    band.low_hz = 1.0;
    band.high_hz = 7.0;
    CHECK(std::abs(rmse(x, y, band) - 0.211288563682129) <= kPrinted);
    SpectralRmseParams normalised;
    normalised.error = SpectralError::normalised;
    CHECK(std::abs(rmse(x, y, normalised) - 0.559016994374947) <= kPrinted);
    SpectralRmseParams fit;
    fit.error = SpectralError::goodness_of_fit;
    CHECK(std::abs(1.0 - rmse(x, y, fit) - 0.894427190999916) <= kPrinted);
    CHECK(std::abs(rmse(x, silence) - 0.333333333333333) <= kPrinted);
}

TEST_CASE("spectral RMSE: blind to shifts of a periodic signal") {
    Waveform shifted = two_lines();
    std::ranges::rotate(shifted.samples_g, shifted.samples_g.begin() + 3);
    CHECK(rmse(spectrum_of(two_lines()), spectrum_of(shifted)) <= 1e-15);
}

TEST_CASE("spectral RMSE: a change of scale of both changes it alike, and relative errors not") {
    const auto x = golden::noise(3, 500, 1.0);
    const auto y = golden::noise(4, 500, 1.0);
    const auto distance = [&](double scale, SpectralError error) {
        SpectralRmseParams params;
        params.error = error;
        return rmse(spectrum_of(mixed(scale, x, 0.0, x)), spectrum_of(mixed(scale, y, 0.0, y)),
                    params);
    };
    const double one = distance(1.0, SpectralError::rmse);
    CHECK(one > 0.0);
    CHECK(std::abs(distance(8.0, SpectralError::rmse) - 8.0 * one) <= 1e-15);
    for (const auto error : {SpectralError::normalised, SpectralError::goodness_of_fit}) {
        CHECK(std::abs(distance(8.0, error) - distance(1.0, error)) <= 1e-14);
    }
}

TEST_CASE("spectral RMSE: silence is 0 from silence, and 1 from sound in relative forms") {
    const Spectrum x = spectrum_of(kOneLine);
    const Spectrum silence = spectrum_of(Waveform{16.0, std::vector<double>(16, 0.0)});
    for (const auto scale : {SpectrumScale::linear, SpectrumScale::decibel}) {
        for (const auto error :
             {SpectralError::rmse, SpectralError::normalised, SpectralError::goodness_of_fit}) {
            SpectralRmseParams params;
            params.scale = scale;
            params.error = error;
            CHECK(rmse(silence, silence, params) == 0.0);
            CHECK(rmse(x, x, params) == 0.0);
            CHECK(rmse(x, silence, params) > 0.0);
            CHECK(std::isfinite(rmse(silence, x, params)));
            if (error == SpectralError::rmse || scale == SpectrumScale::decibel) continue;
            CHECK(rmse(silence, x, params) == 1.0);
        }
    }
    CHECK(spectral_rmse({}, {}) == 0.0);
}

}  // namespace spectral_rmse_test
