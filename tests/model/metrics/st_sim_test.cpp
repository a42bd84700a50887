// Numbers from the design page's worked examples, met by tests/golden/make_metrics.py as well.
#include "model/metrics/st_sim.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace st_sim_test {

using namespace tact;

namespace {

StSim compared(const Waveform& reference, const Waveform& other, const StSimParams& params = {}) {
    return st_sim(st_sim_blocks(reference, params), st_sim_blocks(other, params), params);
}

const Waveform kReference{8000.0, {.3, -.1, .4, .1, -.5, .9, -.2, .6}};
const Waveform kDistorted{8000.0, {.2, -.1, .5, 0, -.5, .7, -.2, .6}};

// 1 s at 8 kHz.
Waveform second_of(double f_hz) { return tone(f_hz, 8000.0, 8000); }

Waveform slowly_modulated() { return product(second_of(4.0), second_of(70.0)); }

// 150 Hz in the first half of 1 s, silence in the rest, or the other way round.
Waveform half_of(bool first, double f_hz) {
    Waveform waveform = tone(f_hz, kModelRateHz, 10'240);
    for (std::size_t n = 0; n < 10'240; ++n) {
        if ((n < 5120) != first) waveform.samples_g[n] = 0.0;
    }
    return waveform;
}

}  // namespace

TEST_CASE("ST-SIM: two blocks of four samples, both ways") {
    StSimParams tiny;
    tiny.spectrum.block_samples = 4;
    const StSim there = compared(kReference, kDistorted, tiny);
    CHECK(std::abs(there.spectral - 0.919391921531628) <= 1e-14);
    CHECK(std::abs(there.temporal - 0.965191737837546) <= 1e-14);
    CHECK(std::abs(there.similarity - 0.949677083457203) <= 1e-14);
    CHECK(std::abs(compared(kDistorted, kReference, tiny).similarity - 1.00459245178233) <= 1e-13);
}

TEST_CASE("ST-SIM: tones, mixes and amplitude modulation of 1 s") {
    const Waveform mix = mixed(0.5, second_of(70.0), 0.5, second_of(210.0));
    const StSim with_mix = compared(second_of(70.0), mix);
    CHECK(std::abs(with_mix.spectral - 1.01487343003) <= 1e-11);
    CHECK(std::abs(with_mix.temporal - 0.706902400917) <= 1e-11);
    CHECK(std::abs(with_mix.similarity - 0.797462491638) <= 1e-11);
    CHECK(std::abs(compared(second_of(70.0), slowly_modulated()).similarity - 0.121003733767) <=
          1e-11);
}

TEST_CASE("ST-SIM: opposed shapes are less alike than unlike ones, or just as much, clamped") {
    const StSim opposed = compared(second_of(210.0), slowly_modulated());
    CHECK(std::abs(opposed.temporal + 0.00229171) <= 5e-9);
    CHECK(std::abs(opposed.similarity + 0.0169350410793) <= 1e-12);
    StSimParams clamped;
    clamped.negative_shape = NegativeShape::clamped;
    CHECK(compared(second_of(210.0), slowly_modulated(), clamped).similarity == 0.0);
    const Waveform turned = mixed(-1.0, second_of(70.0), 0.0, second_of(70.0));
    CHECK(std::abs(compared(second_of(70.0), turned).similarity + 1.0) <= 1e-12);
}

TEST_CASE("ST-SIM: 1 with itself, 0 where one is silent, 1 between silences") {
    const Waveform silence{8000.0, std::vector<double>(8000, 0.0)};
    const StSim same = compared(second_of(70.0), second_of(70.0));
    CHECK(same.spectral == 1.0);
    CHECK(same.temporal == 1.0);
    CHECK(same.similarity == 1.0);
    CHECK(compared(silence, silence).similarity == 1.0);
    CHECK(compared(second_of(70.0), silence).similarity == 0.0);
    CHECK(compared(silence, second_of(70.0)).similarity == 0.0);
}

TEST_CASE("ST-SIM: a constant has no shape") {
    for (const double offset_g : {0.1, 1.0 / 3.0}) {
        const Waveform constant{8000.0, std::vector<double>(1024, offset_g)};
        CHECK(compared(constant, golden::noise(3, 1024, 1.0)).temporal == 0.0);
        CHECK(compared(golden::noise(3, 1024, 1.0), constant).temporal == 0.0);
    }
}

TEST_CASE("ST-SIM: shared silence halves it as published, or is left out") {
    // 10 of 20 blocks sound in both, and there they have half the amplitude: the same shape.
    const Waveform full = half_of(true, 150.0);
    const Waveform half = mixed(0.5, full, 0.0, full);
    CHECK(std::abs(compared(full, half).temporal - 0.5) <= 1e-12);
    StSimParams left_out;
    left_out.shared_silence = SharedSilence::left_out;
    CHECK(std::abs(compared(full, half, left_out).temporal - 1.0) <= 1e-12);
    // Where no block is silent in both the two are one.
    const Waveform other = half_of(false, 150.0);
    CHECK(compared(full, other, left_out).similarity == compared(full, other).similarity);
}

}  // namespace st_sim_test
