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
    return activations(components(spectrum, params), params)[index_of(receptor)];
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

TEST_CASE("activation: of equal neighbouring bins one is the peak") {
    NeuralCodingParams peaks;
    peaks.components = Components::peaks;
    const Spectrum spectrum{1000.0, 10, {0.0, 0.2, 1.0, 1.0, 0.5, 0.9}};
    const std::vector<Component> found = components(spectrum, peaks);
    REQUIRE(found.size() == 2);
    CHECK(found[0].frequency_hz == 300.0);
    CHECK(found[1].frequency_hz == 500.0);
}

TEST_CASE("activation: the rate rises with amplitude and falls with distance to nothing at r_max") {
    double last_hz = 0.0;
    for (const double amplitude_g : {0.05, 0.1, 0.5, 2.0, 5.0, 10.0}) {
        const Activation a = of_tone(amplitude_g, 150.0, Receptor::pacinian);
        CHECK(a.rate_hz > last_hz);
        last_hz = a.rate_hz;
        CHECK(rate_at_hz(a, 0.0) == a.rate_hz);
        CHECK(rate_at_hz(a, kHotZoneMm) == a.rate_hz);
        CHECK(rate_at_hz(a, (kHotZoneMm + a.radius_mm) / 2.0) < a.rate_hz);
        if (a.radius_mm == kFingertipMm) continue;  // there the skin ends before the rate is zero
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

TEST_CASE("activation: no receptor is sought beyond the fingertip, however strong the vibration") {
    // A set file may have all of them; without the limit, the second reaches 4 m.
    for (const auto& [amplitude_g, frequency_hz] :
         {std::pair{1.0, 1.0}, std::pair{500.0, 2.0}, std::pair{1e6, 1.0}, std::pair{1e6, 250.0}}) {
        for (const Receptor receptor : kReceptors) {
            CAPTURE(amplitude_g);
            const Activation a = of_tone(amplitude_g, frequency_hz, receptor);
            CHECK(a.radius_mm > 0.0);
            CHECK(a.radius_mm <= kFingertipMm);
        }
    }
    const Activation strong = of_tone(500.0, 2.0, Receptor::meissner);
    CHECK(strong.radius_mm == kFingertipMm);
    CHECK(rate_at_hz(strong, kFingertipMm) > 0.0);  // the rate at the centre is unchanged
    CHECK(strong.rate_hz > of_tone(50.0, 2.0, Receptor::meissner).rate_hz);
}

TEST_CASE("activation: slopes and thresholds that overflow reach no farther than the fingertip") {
    NeuralCodingParams wild;
    for (Curve& slope : wild.tables.slope) slope = {{10.0}, {1e308}};
    for (Curve& threshold : wild.tables.threshold) threshold = {{10.0}, {-1e300}};
    CHECK(of_tone(1.0, 150.5, Receptor::meissner, wild).radius_mm <= kFingertipMm);
}

}  // namespace activation_test
