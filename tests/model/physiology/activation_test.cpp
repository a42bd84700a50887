#include "model/physiology/activation.h"

#include "model/pattern/pattern.h"
#include "tests/support/golden.h"

namespace activation_test {

using namespace tact;

namespace {

Activation of_tone(double amplitude_g, double frequency_hz, Receptor receptor,
                   const NeuralCodingParams& params = {}) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    const auto spectrum = amplitude_spectrum(without_mean(render(pattern).samples_g), kModelRateHz);
    return activation(components(spectrum, params), receptor, params);
}

}  // namespace

TEST_CASE("activation: 1 g is the displacement that mechanics gives") {
    CHECK(std::abs(displacement_um(1.0, 150.0) - 11.04) <= 0.005);
    CHECK(std::abs(displacement_um(1.0, 70.0) - 50.7) <= 0.05);
    CHECK(std::abs(displacement_um(1.0, 250.0) - 3.97) <= 0.005);
}

TEST_CASE("activation: a 150 Hz tone drives Pacinian receptors as the model page says") {
    const Activation one_g = of_tone(1.0, 150.0, Receptor::pacinian);
    CHECK(std::abs(one_g.rate_hz - 150.91) <= 0.005);
    CHECK(std::abs(one_g.radius_mm - 9.4969) <= 5e-5);
    const Activation tenth = of_tone(0.1, 150.0, Receptor::pacinian);
    CHECK(std::abs(tenth.rate_hz - 57.0) <= 0.5);
    CHECK(std::abs(tenth.radius_mm - 3.0) <= 0.05);
}

TEST_CASE("activation: leakage of a tone between bins is felt, unless only peaks count") {
    NeuralCodingParams peaks;
    peaks.components = Components::peaks;
    CHECK(std::abs(of_tone(1.0, 150.5, Receptor::pacinian).rate_hz - 1017.0) <= 0.5);
    CHECK(of_tone(1.0, 150.5, Receptor::pacinian, peaks).rate_hz < 160.0);
}

TEST_CASE("activation: the rate rises with amplitude and falls with distance to nothing at r_max") {
    double last_hz = 0.0;
    for (const double amplitude_g : {0.05, 0.1, 0.5, 2.0, 10.0}) {
        const Activation a = of_tone(amplitude_g, 150.0, Receptor::pacinian);
        CHECK(a.rate_hz > last_hz);
        last_hz = a.rate_hz;
        CHECK(rate_at_hz(a, 0.0) == a.rate_hz);
        CHECK(rate_at_hz(a, kHotZoneMm) == a.rate_hz);
        CHECK(rate_at_hz(a, (kHotZoneMm + a.radius_mm) / 2.0) < a.rate_hz);
        CHECK(rate_at_hz(a, a.radius_mm) <= 1e-9);
        CHECK(rate_at_hz(a, 2.0 * a.radius_mm) == 0.0);
    }
}

TEST_CASE("activation: for one sinusoid r_max is 1.5 mm sqrt(v / threshold)") {
    const Activation a = of_tone(1.0, 100.0, Receptor::meissner);
    const double threshold_um =
        std::pow(10.0, at(default_tables().threshold[index_of(Receptor::meissner)], 100.0));
    const double expected_mm = 1.5 * std::sqrt(displacement_um(1.0, 100.0) / threshold_um);
    CHECK(std::abs(a.radius_mm - expected_mm) <= 1e-9);
}

TEST_CASE("activation: below threshold nothing fires") {
    CHECK(of_tone(1e-4, 150.0, Receptor::meissner) == Activation{});
    NeuralCodingParams literal;
    literal.subthreshold = Subthreshold::subtracted;
    CHECK(of_tone(1e-4, 150.0, Receptor::meissner, literal) == Activation{});
}

TEST_CASE("activation: band edges are inside for every duration that has a bin there") {
    // 3,000 samples: bin 150 is 500 Hz exactly, but 150 times a rounded 10,000 / 3,000 is not.
    Spectrum spectrum{kModelRateHz, 3000, std::vector<double>(1501, 0.0)};
    spectrum.amplitude_g[150] = 1.0;
    const auto found = components(spectrum, {});
    REQUIRE(found.size() == 1);
    CHECK(found[0].frequency_hz == 500.0);
    spectrum.amplitude_g[151] = 1.0;
    CHECK(components(spectrum, {}).size() == 1);
}

}  // namespace activation_test
