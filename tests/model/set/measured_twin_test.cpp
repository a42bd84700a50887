#include "model/set/measured_twin.h"

#include "model/common/random.h"
#include "tests/support/golden.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/three_tones.h"

namespace measured_twin_test {

using namespace tact;
using golden::noise;

namespace {

using Samples = std::vector<double>;

// `samples` of silence before the waveform and as many after it.
Waveform within_silence(const Waveform& waveform, std::size_t samples) {
    Waveform result{waveform.rate_hz, Samples(samples, 0.0)};
    result.samples_g.insert(result.samples_g.end(), waveform.samples_g.begin(),
                            waveform.samples_g.end());
    return padded(std::move(result), waveform.samples_g.size() + 2 * samples);
}

Waveform with_noise(Waveform waveform, double rms) {
    RandomStream random{random_bits(5, 0), 0};
    for (double& sample : waveform.samples_g) sample += rms * next_normal(random);
    return waveform;
}

const Measurement& measurement(const Vibration& vibration) {
    return std::get<Measurement>(vibration.source);
}

}  // namespace

TEST_CASE("alignment: a delayed copy is found to the sample and cut out, in noise too") {
    const Waveform intended = render(std::get<Pattern>(named_tone("a", 150.0).source));
    const std::size_t lead = 1234;
    const Waveform recording = within_silence(intended, lead);
    const Alignment exact = aligned(recording, intended);
    CHECK(exact.lag == 1234);
    CHECK(exact.waveform == intended);
    CHECK(exact.correlation > 1.0 - 1e-12);
    CHECK(remarks_on(exact).empty());
    const Alignment noisy = aligned(with_noise(recording, 0.1 * rms_g(intended)), intended);
    CHECK(noisy.lag == 1234);
    CHECK(noisy.correlation > 0.9);
}

TEST_CASE("alignment: a sensor mounted upside down makes no difference") {
    const Waveform intended = render(std::get<Pattern>(named_tone("a", 150.0).source));
    Waveform recording = within_silence(intended, 77);
    for (double& sample : recording.samples_g) sample = -0.3 * sample;
    const Alignment alignment = aligned(recording, intended);
    CHECK(alignment.lag == 77);
    CHECK(alignment.correlation > 1.0 - 1e-12);
}

TEST_CASE("alignment: lags equal NumPy's") {
    for (const auto& expected : golden::read("measured.json", "lag")) {
        const std::uint32_t seed = expected.at("seed");
        const std::size_t begin = expected.at("begin");
        const Waveform recording = noise(seed, expected.at("samples"), 1.0);
        Waveform piece = noise(seed + 1, expected.at("length"), 0.5);
        for (std::size_t n = 0; n < piece.samples_g.size(); ++n) {
            piece.samples_g[n] +=
                expected.at("sign").get<double>() * recording.samples_g[begin + n];
        }
        CHECK(aligned(recording, piece).lag == expected.at("lag").get<std::ptrdiff_t>());
    }
}

TEST_CASE("alignment: what a recording misses is silence, and is told") {
    const Waveform intended = noise(3, 1000, 1.0);
    Waveform late{kModelRateHz, {intended.samples_g.begin() + 200, intended.samples_g.end() - 100}};
    const Alignment alignment = aligned(late, intended);
    CHECK(alignment.lag == -200);
    CHECK(alignment.missing_before == 200);
    CHECK(alignment.missing_after == 100);
    CHECK(alignment.waveform.samples_g[199] == 0.0);
    CHECK(alignment.waveform.samples_g[200] == intended.samples_g[200]);
    CHECK(alignment.waveform.samples_g[900] == 0.0);
    REQUIRE(remarks_on(alignment).size() == 2);
    CHECK(contains(remarks_on(alignment)[0], "0.02 s of silence added at its start"));
}

TEST_CASE("alignment: silence, nothing, and another signal") {
    const Waveform intended = noise(3, 100, 1.0);
    const Alignment silent = aligned({kModelRateHz, Samples(500, 0.0)}, intended);
    CHECK(silent.lag == 0);
    CHECK(silent.correlation == 0.0);
    CHECK(silent.waveform.samples_g == Samples(100, 0.0));
    CHECK(aligned({kModelRateHz, {}}, intended).missing_after == 100);
    CHECK(aligned(intended, {kModelRateHz, {}}).waveform.samples_g.empty());
    const Waveform tone_60 = render(std::get<Pattern>(named_tone("a", 60.0).source));
    const Waveform tone_250 = render(std::get<Pattern>(named_tone("a", 250.0).source));
    const auto remarks = remarks_on(aligned(tone_60, tone_250));
    REQUIRE(remarks.size() >= 1);
    CHECK(contains(remarks.back(), "hardly like its pattern"));
}

TEST_CASE("alignment: of the many lags of a steady tone, the least") {
    Pattern steady;
    steady.carriers[0].frequency_hz = 100.0;
    const Waveform intended = render(steady);
    steady.duration_s = 3.0;
    CHECK(aligned(render(steady), intended).lag == 0);
}

TEST_CASE("measured twin: stands behind its pattern, named after it") {
    PatternSet set = three_tones();
    const Waveform recording = within_silence(waveform_of(set.vibrations[1]), 300);
    CHECK(insert_twin(set, measured_twin(set.vibrations[1], recording).vibration) == 2);
    CHECK(insert_twin(set, measured_twin(set.vibrations[1], recording).vibration) == 3);
    CHECK(names_of(set) == std::vector<std::string>{"pulse 1", "pulse 12", "pulse 12 measured",
                                                    "pulse 12 measured 2", "L-4/full"});
    CHECK(measurement(set.vibrations[2]).measures == "pulse 12");
    CHECK_FALSE(measurement(set.vibrations[2]).synthetic);
    CHECK(waveform_of(set.vibrations[2]).samples_g.size() ==
          waveform_of(set.vibrations[1]).samples_g.size());
    const auto synthetic = synthetic_twin(set.vibrations[0], {}).vibration;
    CHECK(synthetic.name == "pulse 1 synthetic");
    CHECK(measurement(synthetic).synthetic);
}

TEST_CASE("measured twin: a recording's pattern is guessed by name, never between two") {
    const PatternSet set = three_tones();
    CHECK(guessed_intended(set, "pulse 1") == 0);
    CHECK(guessed_intended(set, "Pulse_12") == 1);
    CHECK(guessed_intended(set, "pulse-1 measured") == 0);
    CHECK(guessed_intended(set, "pulse_12_measured_3") == 1);
    CHECK(guessed_intended(set, "L-4-full") == 2);
    CHECK(guessed_intended(set, "l4full take 2") == 2);
    CHECK_FALSE(guessed_intended(set, "pulse"));
    CHECK_FALSE(guessed_intended(set, "pulse 1 of Tuesday"));
    CHECK_FALSE(guessed_intended(set, ""));
    PatternSet alike;
    alike.vibrations = {named_tone("a-b", 60.0), named_tone("a b", 70.0)};
    CHECK_FALSE(guessed_intended(alike, "ab"));
    CHECK(guessed_intended(alike, "a b") == 1);
}

TEST_CASE("measured twin: either side of a set, and stand-ins under the intended names") {
    PatternSet set = with_synthetic_twins(three_tones(), {});
    REQUIRE(set.vibrations.size() == 6);
    CHECK(with_synthetic_twins(set, {}).vibrations.size() == 9);  // of patterns, not of twins
    insert_twin(set, measured_twin(set.vibrations[0], waveform_of(set.vibrations[0])).vibration);
    CHECK(names_of(one_side(set, Side::intended)) == names_of(three_tones()));
    CHECK(one_side(set, Side::measured).vibrations.size() == 4);
    CHECK(one_side(set, Side::both) == set);
    const PatternSet stand_ins = measured_stand_ins(set);
    CHECK(names_of(stand_ins) == names_of(three_tones()));
    CHECK(measurement(stand_ins.vibrations[0]).synthetic);
    // Noise of their own.
    CHECK(waveform_of(set.vibrations[1]).samples_g != waveform_of(set.vibrations[4]).samples_g);
}

TEST_CASE("measured twin: of a perfect actuator it is the pattern again") {
    ActuatorParams perfect;
    perfect.resonance_hz = 1.0;
    perfect.noise_g = 0.0;
    const Vibration intended = named_tone("a", 250.0);
    const Twin twin = synthetic_twin(intended, perfect);
    CHECK(twin.alignment.lag == 200);  // the onset
    CHECK(golden::worst_difference(waveform_of(twin.vibration).samples_g,
                                   waveform_of(intended).samples_g) < 0.01);
}

TEST_CASE("alignment: a lag that is better by a thousandth is better") {
    Waveform click{kModelRateHz, Samples(100, 0.0)};
    click.samples_g[0] = 1.0;
    Waveform recording{kModelRateHz, Samples(1000, 0.0)};
    recording.samples_g[0] = 0.999;
    recording.samples_g[300] = 1.0;
    CHECK(aligned(recording, click).lag == 300);
}

}  // namespace measured_twin_test
