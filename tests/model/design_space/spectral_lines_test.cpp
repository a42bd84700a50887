#include "model/design_space/spectral_lines.h"

#include <cmath>

#include "model/signal/spectrum.h"
#include "tests/support/golden.h"

namespace spectral_lines_test {

using namespace tact;

namespace {

// 1 s, so that whole frequencies lie on whole bins.
Pattern unusual(ModulationKind kind, double modulation_hz) {
    Pattern pattern;
    pattern.amplitude_g = 1.5;
    pattern.carriers = {{70.0, 0.6, 0.3}, {150.0, -0.4, 1.0}, {150.0, 0.2, 2.0}, {130.0, 0.1, 0.0}};
    pattern.modulation = {kind, modulation_hz, 0.7};
    return pattern;
}

void check_against_spectrum(const Pattern& pattern) {
    const Spectrum spectrum = amplitude_spectrum(render(pattern).samples_g, kModelRateHz);
    std::vector<double> expected = spectrum.amplitude_g;
    expected[0] = 0.0;  // no vibration
    std::vector<double> got(expected.size(), 0.0);
    for (const SpectralLine& line : spectral_lines(pattern)) {
        const auto bin = static_cast<std::size_t>(std::lround(line.frequency_hz));
        CHECK(std::abs(line.frequency_hz - static_cast<double>(bin)) < 1e-9);
        CHECK(got[bin] == 0.0);
        got[bin] = line.amplitude_g;
    }
    CHECK(golden::worst_difference(got, expected) < 1e-10);
}

}  // namespace

TEST_CASE("spectral lines: what the Fourier transform of the samples finds") {
    for (const ModulationKind kind : {ModulationKind::product, ModulationKind::am}) {
        for (const double modulation_hz : {0.0, 4.0, 10.0, 70.0, 100.0}) {
            CAPTURE(modulation_hz);
            check_against_spectrum(unusual(kind, modulation_hz));
        }
    }
}

TEST_CASE("spectral lines: none of silence, and none of carriers that cancel") {
    Pattern pattern;
    pattern.amplitude_g = 0.0;
    CHECK(spectral_lines(pattern).empty());
    pattern.amplitude_g = 1.0;
    pattern.carriers = {{100.0, 0.5, 0.0}, {100.0, -0.5, 0.0}};
    CHECK(spectral_lines(pattern).empty());
    CHECK(most_displacement_um({}) == 0.0);
    CHECK_FALSE(detectability_db({}, default_tables()));
}

TEST_CASE("spectral lines: displacement of 1 g is 11.04 um at 150 Hz, and lines add up") {
    CHECK(std::abs(most_displacement_um({{150.0, 1.0}}) - 11.04) < 0.005);
    CHECK(std::abs(most_displacement_um({{150.0, 1.0}, {70.0, 1.0}}) - 61.74) < 0.05);
}

TEST_CASE("spectral lines: detectability is the distance to the nearest threshold below") {
    const PhysiologyTables& tables = default_tables();
    const double f_hz = 250.0;
    double lowest = 1e9;
    for (const Receptor receptor : kReceptors) {
        lowest = std::min(lowest, at(tables.threshold[index_of(receptor)], f_hz));
    }
    const double threshold_g = std::pow(10.0, lowest) / displacement_um(1.0, f_hz);
    CHECK(std::abs(*detectability_db({{f_hz, threshold_g}}, tables)) < 1e-9);
    CHECK(std::abs(*detectability_db({{f_hz, 10.0 * threshold_g}}, tables) - 20.0) < 1e-9);
    CHECK(std::abs(*detectability_db({{f_hz, threshold_g}, {251.0, 1e-7}}, tables)) < 1e-9);
    CHECK_FALSE(detectability_db({{0.5, 10.0}, {501.0, 10.0}}, tables));
}

}  // namespace spectral_lines_test
