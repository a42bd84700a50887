// Samples that are written, read back.
#include <doctest/doctest.h>

#include "model/io/formats/samples/samples.h"
#include "model/io/recordings/acceleration_table.h"
#include "tests/model/io/effects_out/written_patterns.h"
#include "tests/support/temporary_folder.h"

namespace samples_round_trip_test {

using namespace tact;
using namespace tact::written_patterns;

TEST_CASE("round trip: WAV of floats holds 1e-6 g, of 16 and 24 bits half a step, at each rate") {
    std::mt19937 random(31);
    for (const double rate_hz : {10'000.0, 44'100.0, 48'000.0}) {
        for (const auto encoding :
             {WaveEncoding::float32, WaveEncoding::int16, WaveEncoding::int24}) {
            CAPTURE(rate_hz);
            CAPTURE(static_cast<int>(encoding));
            Pattern pattern = some_pattern(random, {});
            pattern.amplitude_g = between(random, 0.1, 12.0);
            const Waveform meant = render(pattern, rate_hz);
            const double full_g = full_scale_of(peak_g(meant), encoding);
            const EffectTarget target{"one", {}, {}, {rate_hz, encoding, full_g}};
            const auto written = write_effect(TargetFormat::wav, pattern, target);
            TemporaryFolder folder;
            folder.write("one.wav", written.text);
            folder.write("one.wav.json", written.beside);
            const auto read = read_wave_channels(folder.path / "one.wav");
            REQUIRE(read);
            CHECK(read->rate_hz == rate_hz);
            CHECK(read->scale_g == full_g);
            CHECK(read->remark.empty());
            double largest_g = 0.0;
            REQUIRE(read->channels.front().size() == meant.samples_g.size());
            for (std::size_t n = 0; n < meant.samples_g.size(); ++n) {
                const double back_g = full_g * read->channels.front()[n];
                largest_g = std::max(largest_g, std::abs(back_g - meant.samples_g[n]));
            }
            const double steps = encoding == WaveEncoding::int16 ? 32768.0 : 8388608.0;
            const bool floats = encoding == WaveEncoding::float32;
            CHECK(largest_g <= (floats ? 1e-6 : 0.5 * full_g / steps * (1.0 + 1e-9)));
            if (encoding != WaveEncoding::int16) CHECK(written.remarks.empty());
        }
    }
}

TEST_CASE("round trip: steps of a WAV are said where they may be felt") {
    Pattern pattern;
    pattern.amplitude_g = 0.4;
    for (const double full_g : {0.5, 40.0}) {
        const EffectTarget target{"one", {}, {}, {48'000.0, WaveEncoding::int16, full_g}};
        const auto written = write_effect(TargetFormat::wav, pattern, target);
        CHECK(written.remarks.empty() == (full_g < 1.0));
    }
}

TEST_CASE("round trip: CSV of accelerations is exact") {
    std::mt19937 random(32);
    for (int k = 0; k < 5; ++k) {
        const Pattern pattern = some_pattern(random, {});
        const EffectTarget target{"one", {}, {}, {10'000.0, WaveEncoding::int24, 0.0}};
        const auto written = write_effect(TargetFormat::csv, pattern, target);
        CHECK(written.remarks.empty());
        CHECK(written.beside.empty());
        CHECK(written.text.starts_with("time_s,acceleration_g\n0,0\n"));
        const auto table = parse_acceleration_table(written.text, "one.csv", true);
        REQUIRE(table);
        CHECK(table->axes.size() == 1);
        CHECK(table->unit == AccelerationUnit::g);
        CHECK(table->axes.front() == render(pattern, 10'000.0).samples_g);
        for (std::size_t n = 0; n < table->time.size(); ++n) {
            REQUIRE(table->time[n] == static_cast<double>(n) / 10'000.0);
        }
    }
}

TEST_CASE("round trip: what is louder than the full scale of a WAV is turned down, and says so") {
    Pattern pattern;
    pattern.amplitude_g = 2.0;
    pattern.duration_s = 0.1;
    const EffectTarget target{"one", {}, {}, {48'000.0, WaveEncoding::int16, 0.5}};
    const auto written = write_effect(TargetFormat::wav, pattern, target);
    CHECK(written.remarks.front() == "louder than full scale: scaled by 0.25");
    CHECK(peak_g(parse_wave({written.text, written.beside}, "x")->waveform) < 0.51);
    CHECK(peak_g(parse_wave({written.text, written.beside}, "x")->waveform) > 0.49);
}

}  // namespace samples_round_trip_test
