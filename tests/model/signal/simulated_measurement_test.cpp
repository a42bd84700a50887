#include "model/signal/simulated_measurement.h"

#include <cmath>
#include <vector>

#include "model/pattern/pattern.h"
#include "tests/support/golden.h"

namespace simulated_measurement_test {

using namespace tact;
using golden::noise;
using Samples = std::vector<double>;

TEST_CASE("simulated measurement: the resonance equals SciPy's") {
    for (const auto& expected : golden::read("measured.json", "resonance")) {
        ActuatorParams params;
        params.resonance_hz = expected.at("resonance_hz");
        params.q = expected.at("q");
        params.gain = expected.at("gain");
        params.onset_s = 0.0;
        params.noise_g = 0.0;
        const std::size_t samples = expected.at("samples");
        auto got = simulated_measurement(noise(expected.at("seed"), samples, 1.0), params);
        got.samples_g.resize(samples);
        CHECK(golden::worst_difference(got.samples_g, expected.at("expected")) < 1e-11);
    }
}

TEST_CASE("simulated measurement: Q at the resonance, the gain far above, little far below") {
    ActuatorParams params;
    params.resonance_hz = 80.0;
    params.q = 5.0;
    params.gain = 2.0;
    params.noise_g = 0.0;
    const auto gain_at = [&params](double frequency_hz) {
        Pattern pattern;
        pattern.carriers[0].frequency_hz = frequency_hz;
        const Samples samples = simulated_measurement(render(pattern), params).samples_g;
        return peak_g({kModelRateHz, Samples(samples.begin() + 7000, samples.begin() + 9000)});
    };
    CHECK(std::abs(gain_at(80.0) - 10.0) < 0.02);
    CHECK(std::abs(gain_at(900.0) - 2.0) < 0.03);
    CHECK(gain_at(8.0) < 0.025);
}

TEST_CASE("simulated measurement: onset, noise and its seed") {
    ActuatorParams params;
    params.noise_g = 0.0;
    params.onset_s = 0.05;
    const Waveform drive = noise(1, 1000, 1.0);
    const Waveform still = simulated_measurement(drive, params);
    CHECK(still.samples_g.size() == 1000 + 500 + 1000);
    CHECK(peak_g({kModelRateHz, Samples(still.samples_g.begin(), still.samples_g.begin() + 500)}) ==
          0.0);
    CHECK(still.samples_g[500] != 0.0);
    params.noise_g = 0.2;
    const Waveform silence{kModelRateHz, Samples(50'000, 0.0)};
    const Waveform noisy = simulated_measurement(silence, params);
    CHECK(std::abs(rms_g(noisy) - 0.2) < 0.003);
    CHECK(noisy == simulated_measurement(silence, params));
    params.seed = 2;
    CHECK(noisy.samples_g != simulated_measurement(silence, params).samples_g);
}

}  // namespace simulated_measurement_test
