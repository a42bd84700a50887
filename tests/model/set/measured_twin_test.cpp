#include "model/set/measured_twin.h"

#include <cmath>

#include "model/common/random.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/set_file.h"
#include "model/signal/dft321.h"
#include "model/signal/spectrum.h"
#include "tests/support/golden.h"
#include "tests/support/temporary_folder.h"

namespace measured_twin_test {

using namespace tact;
using golden::noise;

namespace {

using Samples = std::vector<double>;

double energy(const Samples& samples) {
    double sum = 0.0;
    for (const double sample : samples) sum += sample * sample;
    return sum;
}

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

Vibration tone(const std::string& name, double frequency_hz) {
    Pattern pattern;
    pattern.carriers[0].frequency_hz = frequency_hz;
    pattern.rhythm = {"x=-x----", 0.05};
    pattern.duration_s = 0.4;
    Vibration vibration;
    vibration.name = name;
    vibration.source = pattern;
    return vibration;
}

PatternSet three_tones() {
    PatternSet set;
    set.vibrations = {tone("pulse 1", 60.0), tone("pulse 12", 150.0), tone("L-4/full", 250.0)};
    return set;
}

const Measurement& measurement(const Vibration& vibration) {
    return std::get<Measurement>(vibration.source);
}

}  // namespace

TEST_CASE("spectrum: half a spectrum gives its samples back") {
    for (const std::size_t count : {1U, 2U, 37U, 64U}) {
        const Samples samples = noise(9, count, 1.0).samples_g;
        CHECK(golden::worst_difference(samples_of(half_spectrum(samples), count), samples) < 1e-14);
    }
    CHECK(half_spectrum({}).empty());
    CHECK(samples_of({}, 0).empty());
}

TEST_CASE("dft321: equals NumPy") {
    for (const auto& expected : golden::read("measured.json", "dft321")) {
        std::vector<Samples> axes;
        for (const std::uint32_t seed : expected.at("seeds")) {
            const double amplitude = 1.0 + static_cast<double>(axes.size());
            axes.push_back(without_mean(noise(seed, expected.at("samples"), amplitude).samples_g));
        }
        CHECK(golden::worst_difference(dft321(axes), expected.at("expected")) < 1e-12);
    }
}

TEST_CASE("dft321: energy is kept, and a single axis comes out as it was") {
    std::vector<Samples> axes;
    double sum = 0.0;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        axes.push_back(noise(seed, 1001, 1.0).samples_g);
        sum += energy(axes.back());
    }
    CHECK(std::abs(energy(dft321(axes)) - sum) < 1e-11 * sum);
    axes[0].assign(1001, 0.0);
    axes[2].assign(1001, 0.0);
    CHECK(golden::worst_difference(dft321(axes), axes[1]) < 1e-12);
    // Axes that cancel still move.
    axes[0] = axes[1];
    for (double& sample : axes[0]) sample = -sample;
    CHECK(std::abs(energy(dft321(axes)) - 2.0 * energy(axes[1])) < 1e-11 * sum);
    CHECK(dft321({}).empty());
    CHECK(dft321(std::vector<Samples>(3)).empty());
    CHECK(dft321(std::vector<Samples>(3, Samples(5, 0.0))) == Samples(5, 0.0));
}

TEST_CASE("alignment: a delayed copy is found to the sample and cut out, in noise too") {
    const Waveform intended = render(std::get<Pattern>(tone("a", 150.0).source));
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
    const Waveform intended = render(std::get<Pattern>(tone("a", 150.0).source));
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
    const Waveform tone_60 = render(std::get<Pattern>(tone("a", 60.0).source));
    const Waveform tone_250 = render(std::get<Pattern>(tone("a", 250.0).source));
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
    alike.vibrations = {tone("a-b", 60.0), tone("a b", 70.0)};
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
    const Vibration intended = tone("a", 250.0);
    const Twin twin = synthetic_twin(intended, perfect);
    CHECK(twin.alignment.lag == 200);  // the onset
    CHECK(golden::worst_difference(waveform_of(twin.vibration).samples_g,
                                   waveform_of(intended).samples_g) < 0.01);
}

TEST_CASE("measured files: a set with twins is the same set when it is read again") {
    const TemporaryFolder folder;
    const auto file = folder.path / "sub" / "set.tactspace.json";
    std::filesystem::create_directories(file.parent_path());
    PatternSet set = with_synthetic_twins(three_tones(), {});
    REQUIRE(store_measurements(set, file));
    REQUIRE(write_set_file(file, set));
    const auto again = read_set_file(file);
    REQUIRE_MESSAGE(again, again.error().message);
    CHECK(again->set == set);
    CHECK(again->remarks.empty());
    CHECK(measurement(again->set.vibrations[1]).synthetic);
    const std::string text = bytes_of(file);
    CHECK(contains(text, "\"waveform\": \"measured/pulse 1 synthetic.wav\""));
    CHECK(contains(text, "\"waveform\": \"measured/L-4-full synthetic.wav\""));
    CHECK(contains(text, "\"synthetic\": true"));
    CHECK(contains(text, "\"measures\": \"pulse 1\""));
}

TEST_CASE("measured files: nothing that is there is lost, nothing is stored twice") {
    const TemporaryFolder folder;
    const auto file = folder.path / "set.json";
    PatternSet set = with_synthetic_twins(three_tones(), {});
    PatternSet other = set;
    REQUIRE(store_measurements(set, file));
    REQUIRE(store_measurements(other, file));
    CHECK(set == other);
    CHECK(file_count(folder.path / "measured") == 3);
    ActuatorParams noisier;
    noisier.seed = 2;
    PatternSet second = with_synthetic_twins(three_tones(), noisier);
    REQUIRE(store_measurements(second, file));
    CHECK(measurement(second.vibrations[1]).path ==
          (std::filesystem::weakly_canonical(folder.path) / "measured/pulse 1 synthetic 2.wav"));
    CHECK(file_count(folder.path / "measured") == 6);
    folder.write("blocked/measured", "a file");
    PatternSet third = with_synthetic_twins(three_tones(), {});
    CHECK_FALSE(store_measurements(third, folder.path / "blocked" / "set.json"));
    CHECK(measurement(third.vibrations[1]).path.empty());
}

TEST_CASE("measured files: what was kept elsewhere for the time being moves to the set") {
    const TemporaryFolder folder;
    const auto kept = std::filesystem::weakly_canonical(folder.path) / "state";
    PatternSet set = with_synthetic_twins(three_tones(), {});
    for (std::size_t k : {1U, 3U}) {
        auto& of_twin = std::get<Measurement>(set.vibrations[k].source);
        const auto path =
            store_waveform(*of_twin.waveform, set.vibrations[k].name, k == 1 ? kept : folder.path);
        REQUIRE(path);
        of_twin.path = path->string();
    }
    const std::string elsewhere = measurement(set.vibrations[3]).path;
    REQUIRE(store_measurements(set, folder.path / "set.json", kept));
    CHECK(contains(measurement(set.vibrations[1]).path, "/measured/"));
    CHECK(measurement(set.vibrations[3]).path == elsewhere);
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
