// What is written, read back by our own readers with the same actuator map.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/io/effects/ahap_pair.h"
#include "model/io/effects/read_effects.h"
#include "model/io/effects_out/write_effect.h"
#include "model/io/recordings/acceleration_table.h"
#include "model/pattern/drawn_fault.h"
#include "tests/support/temporary_folder.h"

namespace round_trip_test {

using namespace tact;

namespace {

constexpr int kPatterns = 60;  // of each format

// Linear, no ducking, and one length of transients: nothing that only a map would lose.
ActuatorMap plain_map() {
    ActuatorMap map;
    map.name = "plain";
    map.frequency_hz = {50.0, 250.0};
    map.full_scale_g = 2.0;
    map.burst_at_0 = {60.0, 0.020, BurstShape::sine};
    map.burst_at_1 = {240.0, 0.020, BurstShape::sine};
    return map;
}

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

int whole(std::mt19937& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

// What a format can hold.
struct Holds {
    bool jumps = true;
    bool transients = true;
    bool begins_at_0 = false;
    double tick_s = 1e-4;  // of times
    int least_gap_ticks = 1;
    int least_points = 2;
    int most_points = 40;
    double frequency_step = 0.0;  // share of 50 to 250 Hz
};

double some_hz(std::mt19937& random, const Holds& holds) {
    const double share = between(random, 0.0, 1.0);
    if (holds.frequency_step == 0.0) return 50.0 + 200.0 * share;
    return 50.0 + 200.0 * holds.frequency_step * std::round(share / holds.frequency_step);
}

Pattern some_pattern(std::mt19937& random, const Holds& holds) {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers.front().frequency_hz = some_hz(random, holds);
    const bool sweeps = whole(random, 0, 1) == 1;
    const int points = whole(random, holds.least_points, holds.most_points);
    int ticks = 0;
    for (int k = 0; k < points; ++k) {
        const double t_s = ticks * holds.tick_s;
        const double value = k == 0 && holds.begins_at_0 ? 0.0 : between(random, 0.0, 1.0);
        pattern.amplitude_curve.push_back({t_s, value});
        const bool jump = holds.jumps && k > 0 && whole(random, 0, 3) == 0;
        if (jump) pattern.amplitude_curve.push_back({t_s, between(random, 0.0, 1.0)});
        if (sweeps) pattern.frequency_curve.push_back({t_s, some_hz(random, holds)});
        pattern.duration_s = t_s;
        ticks += holds.least_gap_ticks + whole(random, 0, static_cast<int>(0.08 / holds.tick_s));
    }
    if (!holds.transients || pattern.duration_s < 0.1) return pattern;
    const int taps = whole(random, 0, 4);
    for (int k = 0; k < taps; ++k) {
        const int ms = 5 + 25 * k;
        if (1e-3 * ms > pattern.duration_s - 0.03) break;
        // As strong as some intensity from 0.6 on, and above all that is continuous.
        for (const Transient& one :
             transients_on(plain_map(), 1e-3 * ms, 0.01 * whole(random, 60, 100),
                           0.01 * whole(random, 0, 100))) {
            pattern.transients.push_back(one);
        }
    }
    return pattern;
}

EffectsRead read_back(const std::string& text) {
    const auto read = read_effects(text, "a.x", plain_map());
    REQUIRE_MESSAGE(read, (read ? "" : read.error().message + "\n" + text));
    REQUIRE(read->effects.size() == 1);
    REQUIRE(!drawn_fault(read->effects.front().pattern));
    return *read;
}

EffectsRead pair_back(const WrittenEffect& written) {
    const auto pair = joined_pair(*read_effects(written.text, "a_continuous.ahap", plain_map()),
                                  *read_effects(written.beside, "a_transients.ahap", plain_map()));
    REQUIRE(pair);
    REQUIRE(!drawn_fault(pair->effects.front().pattern));
    return *pair;
}

EffectsRead read_back(TargetFormat format, const WrittenEffect& written) {
    return format == TargetFormat::ahap_pair ? pair_back(written) : read_back(written.text);
}

double largest_difference_g(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.0001) {
        largest = std::max(largest, std::abs(envelope_g(a, t_s) - envelope_g(b, t_s)));
    }
    return largest;
}

double largest_difference_hz(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.0001) {
        if (!(envelope_g(a, t_s) > 1e-9)) continue;
        largest = std::max(largest, std::abs(first_carrier_hz(a, t_s) - first_carrier_hz(b, t_s)));
    }
    return largest;
}

bool same_transients(const Pattern& a, const Pattern& b) {
    return std::ranges::equal(
        a.transients, b.transients, [](const Transient& one, const Transient& other) {
            return std::abs(one.time_s - other.time_s) < 1e-9 &&
                   std::abs(one.amplitude_g - other.amplitude_g) < 1e-6 &&
                   std::abs(one.frequency_hz - other.frequency_hz) < 1e-6 &&
                   std::abs(one.duration_s - other.duration_s) < 1e-9 && one.shape == other.shape;
        });
}

// Equal in what a plain pattern has: the carrier's envelope and frequency, and transients.
bool is_equal(const Pattern& a, const Pattern& b) {
    return std::abs(a.duration_s - b.duration_s) < 1e-9 && largest_difference_g(a, b) < 1e-6 &&
           largest_difference_hz(a, b) < 1e-6 && same_transients(a, b);
}

void check_held(TargetFormat format, const Holds& holds, bool quiet = true) {
    std::mt19937 random(20261122);
    for (int k = 0; k < kPatterns; ++k) {
        CAPTURE(k);
        const Pattern pattern = some_pattern(random, holds);
        const WrittenEffect written = write_effect(format, pattern, {"one", plain_map()});
        const EffectsRead read = read_back(written.text);
        const Pattern& back = read.effects.front().pattern;
        CAPTURE(written.text);
        CHECK(std::abs(back.duration_s - pattern.duration_s) < 1e-9);
        CHECK(largest_difference_g(pattern, back) < 1e-6);
        CHECK(largest_difference_hz(pattern, back) < 1e-6);
        CHECK(same_transients(pattern, back));
        const std::string first = written.remarks.empty() ? "" : written.remarks.front();
        if (quiet) CHECK(first == "");
    }
}

}  // namespace

TEST_CASE("round trip: .haptic holds curves, jumps and transients") {
    check_held(TargetFormat::haptic, {});
}

TEST_CASE("round trip: Pulsar's presets hold curves, jumps and transients") {
    check_held(TargetFormat::pulsar, {});
}

TEST_CASE("round trip: AHAP holds curves, however many chunks of 16 points they make") {
    check_held(TargetFormat::ahap, {.transients = false, .most_points = 100});
}

TEST_CASE("round trip: a pair of AHAP holds curves in one file and transients in the other") {
    std::mt19937 random(7);
    for (int k = 0; k < kPatterns; ++k) {
        const Pattern pattern = some_pattern(random, {});
        const auto written = write_effect(TargetFormat::ahap_pair, pattern, {"one", plain_map()});
        CHECK(written.remarks.empty());
        const Pattern curves = read_back(written.text).effects.front().pattern;
        CHECK(curves.transients.empty());
        const Pattern bursts = read_back(written.beside).effects.front().pattern;
        CHECK(same_transients(pattern, bursts));
        CHECK(envelope_g(bursts, 0.01) == 0.0);
        const Pattern pair = pair_back(written).effects.front().pattern;
        CHECK(is_equal(pattern, pair));
    }
}

TEST_CASE("round trip: two AHAP are a pair by their names, one project, and a silent second one") {
    Pattern pattern;
    pattern.duration_s = 0.3;
    pattern.transients = {transients_on(plain_map(), 0.1, 0.8, 0.5).front()};
    const auto written = write_effect(TargetFormat::ahap_pair, pattern, {"tap", plain_map()});
    const auto other = write_effect(TargetFormat::ahap_pair, pattern, {"top", plain_map()});
    const auto read = [](const std::string& text, const std::string& path) {
        return *read_effects(text, path, plain_map());
    };
    const EffectsRead first = read(written.text, "d/x_continuous.ahap");
    CHECK(second_of_pair("d/x_continuous.ahap") == "d/x_transients.ahap");
    CHECK_FALSE(second_of_pair("d/x_transients.ahap"));
    CHECK_FALSE(second_of_pair("d/x.ahap"));
    const auto pair = joined_pair(first, read(written.beside, "d/x_transients.ahap"));
    REQUIRE(pair);
    CHECK(pair->effects.front().name == "x");
    CHECK_FALSE(joined_pair(first, read(other.beside, "d/x_transients.ahap")));
    CHECK_FALSE(joined_pair(first, read(written.text, "d/x_transients.ahap")));
    CHECK_FALSE(joined_pair(read(written.text, "d/x.ahap"), read(written.beside, "d/y.ahap")));
}

TEST_CASE(
    "round trip: a transient behind the end of a pair's first file makes the pattern longer") {
    Pattern pattern;
    pattern.duration_s = 0.2;
    const ActuatorMap map = plain_map();
    Pattern late = pattern;
    late.duration_s = 0.5;
    late.transients = {transients_on(map, 0.4, 0.8, 0.5).front()};
    const auto first = write_effect(TargetFormat::ahap_pair, pattern, {"x", map});
    const auto second = write_effect(TargetFormat::ahap_pair, late, {"x", map});
    const auto pair = joined_pair(*read_effects(first.text, "x_continuous.ahap", map),
                                  *read_effects(second.beside, "x_transients.ahap", map));
    REQUIRE(pair);
    const Pattern& both = pair->effects.front().pattern;
    CHECK_FALSE(drawn_fault(both));
    CHECK(both.duration_s > 0.4);
    CHECK(envelope_g(both, 0.1) > 0.5);
    CHECK(envelope_g(both, 0.3) == 0.0);
    CHECK(same_transients(late, both));
}

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
            CHECK(written.remarks.empty() == floats);
        }
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

TEST_CASE("round trip: HJIF holds curves at whole Hz, and transients") {
    std::mt19937 random(3);
    for (int k = 0; k < kPatterns; ++k) {
        Pattern pattern = some_pattern(random, {.frequency_step = 0.005});
        for (Transient& one : pattern.transients) {
            one.frequency_hz = std::round(one.frequency_hz);
            one.amplitude_g *= 0.9;  // not above full scale at another frequency
        }
        pattern.carriers.front().phase_rad = between(random, 0.0, 6.0);
        const auto written = write_effect(TargetFormat::hjif, pattern, {"one", plain_map()});
        const Pattern back = read_back(written.text).effects.front().pattern;
        CAPTURE(written.text);
        CHECK(is_equal(pattern, back));
        CHECK(back.carriers.front().phase_rad == doctest::Approx(pattern.carriers[0].phase_rad));
        CHECK(written.remarks.empty());
    }
}

TEST_CASE("round trip: HJIF holds several carriers, their weights and phases") {
    Pattern pattern;
    pattern.amplitude_g = 0.5;
    pattern.carriers = {{70.0, 1.0, 0.5}, {230.0, 0.4, 1.5}, {150.0, 0.8, 0.0}};
    pattern.rhythm = {"x=-x", 0.125};
    pattern.duration_s = 1.0;
    const auto written = write_effect(TargetFormat::hjif, pattern, {"three", plain_map()});
    CHECK(written.remarks.empty());
    const Pattern back = read_back(written.text).effects.front().pattern;
    REQUIRE(back.carriers.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(back.carriers[k].frequency_hz == pattern.carriers[k].frequency_hz);
        CHECK(back.carriers[k].weight == doctest::Approx(pattern.carriers[k].weight));
        CHECK(back.carriers[k].phase_rad == pattern.carriers[k].phase_rad);
    }
    CHECK(largest_difference_g(pattern, back) < 1e-6);
}

TEST_CASE("round trip: Android's envelopes hold points at least 20 ms apart, from silence on") {
    check_held(TargetFormat::android_xml, {.jumps = false,
                                           .transients = false,
                                           .begins_at_0 = true,
                                           .tick_s = 1e-3,
                                           .least_gap_ticks = 20,
                                           .most_points = 17});
}

TEST_CASE("round trip: .he holds points at whole ms and frequencies in 1/100 of the band") {
    check_held(TargetFormat::he, {.jumps = false,
                                  .tick_s = 1e-3,
                                  .least_gap_ticks = 1,
                                  .least_points = 4,
                                  .frequency_step = 0.01});
}

TEST_CASE("round trip: timings and amplitudes hold steps of 10 ms and 1/255") {
    std::mt19937 random(11);
    for (const TargetFormat format : {TargetFormat::android_timings, TargetFormat::hla}) {
        for (int k = 0; k < kPatterns; ++k) {
            Pattern pattern;
            pattern.amplitude_g = 2.0;
            const int steps = whole(random, 1, 60);
            for (int n = 0; n < steps; ++n) {
                const double value = whole(random, 0, 255) / 255.0;
                pattern.amplitude_curve.push_back({n * 0.01, value});
                pattern.amplitude_curve.push_back({(n + 1) * 0.01, value});
            }
            pattern.duration_s = steps * 0.01;
            pattern.amplitude_curve.back().time_s = pattern.duration_s;
            const auto written = write_effect(format, pattern, {"steps", plain_map()});
            const Pattern back = read_back(written.text).effects.front().pattern;
            CHECK(back.duration_s == doctest::Approx(pattern.duration_s));
            CHECK(largest_difference_g(pattern, back) < 1e-6);
        }
    }
}

TEST_CASE("round trip: laws that are not straight are met within 1 % of full scale and 1 Hz") {
    ActuatorMap map = plain_map();
    map.intensity_law = IntensityLaw::squared;
    map.frequency_law = FrequencyLaw::logarithmic;
    std::mt19937 random(5);
    for (int k = 0; k < 20; ++k) {
        const Pattern pattern = some_pattern(random, {.transients = false, .least_gap_ticks = 100});
        for (const TargetFormat format : {TargetFormat::haptic, TargetFormat::ahap}) {
            const auto written = write_effect(format, pattern, {"one", map});
            const auto read = read_effects(written.text, "a.x", map);
            REQUIRE(read);
            CHECK(largest_difference_g(pattern, read->effects[0].pattern) < 0.02);
            CHECK(largest_difference_hz(pattern, read->effects[0].pattern) < 1.0);
        }
    }
}

// Anything that a pattern can be, also what no format holds.
Pattern wild_pattern(std::mt19937& random) {
    Pattern pattern = some_pattern(random, {});
    pattern.amplitude_g = between(random, 0.1, 4.0);
    if (whole(random, 0, 2) == 0) pattern.carriers.push_back({between(random, 20, 400), 0.7, 1.0});
    if (whole(random, 0, 2) == 0) pattern.modulation.frequency_hz = between(random, 1, 60);
    if (whole(random, 0, 1) == 0) pattern.modulation.kind = ModulationKind::am;
    if (whole(random, 0, 2) == 0) pattern.rhythm = {"x=-x", 0.0371};
    if (whole(random, 0, 2) == 0) pattern.attack_s = 0.013;
    if (whole(random, 0, 3) == 0) pattern.carriers.front().frequency_hz = between(random, 1, 900);
    if (whole(random, 0, 3) == 0) pattern.carriers.front().phase_rad = 1.0;
    for (Transient& one : pattern.transients) {
        if (whole(random, 0, 3) == 0) one.duration_s = between(random, 0.002, 0.1);
        if (whole(random, 0, 3) == 0) one.frequency_hz = between(random, 1, 900);
        if (whole(random, 0, 3) == 0) one.shape = TransientShape::square;
    }
    return pattern;
}

bool is_plain(const Pattern& pattern) {
    return pattern.carriers.size() == 1 && pattern.modulation.frequency_hz == 0.0 &&
           pattern.carriers.front().phase_rad == 0.0;
}

// What every format holds, but for the steps of timings.
Pattern mild_pattern() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers.front().frequency_hz = 150.0;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.1, 1.0}, {0.2, 0.4}, {0.3, 0.8}, {0.4, 0.2}};
    pattern.duration_s = 0.4;
    return pattern;
}

Transient mild_transient(double time_s) {
    return transients_on(plain_map(), time_s, 0.9, 0.5).front();
}

// The mild pattern with one thing that some format cannot hold.
std::vector<Pattern> odd_patterns() {
    std::vector<Pattern> all;
    const auto add = [&](auto change) {
        Pattern pattern = mild_pattern();
        change(pattern);
        all.push_back(pattern);
    };
    add([](Pattern&) {});
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.1; });
    add([](Pattern& p) { p.amplitude_curve[0].value = 0.5; });
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.103; });
    add([](Pattern& p) { p.amplitude_curve[2].time_s = 0.20033; });
    add([](Pattern& p) { p.duration_s = p.amplitude_curve.back().time_s = 0.40033; });
    add([](Pattern& p) { p.carriers.push_back({200.0, 0.5, 0.0}); });
    add([](Pattern& p) { p.carriers.front().phase_rad = 1.0; });
    add([](Pattern& p) { p.carriers.front().frequency_hz = 150.4; });
    add([](Pattern& p) { p.carriers.front().frequency_hz = 420.0; });
    add([](Pattern& p) { p.frequency_curve = {{0.0, 100.0}, {0.4, 200.0}}; });
    add([](Pattern& p) { p.frequency_curve = {{0.2, 100.0}, {0.2, 200.0}}; });
    add([](Pattern& p) { p.amplitude_g = 3.0; });
    add([](Pattern& p) { p.modulation.frequency_hz = 4.0; });
    add([](Pattern& p) { p.modulation = {ModulationKind::am, 80.0, 0.5}; });
    add([](Pattern& p) { p.rhythm = {"x-", 0.1}; });
    add([](Pattern& p) { p.attack_s = 0.05; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15), mild_transient(0.16)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.15033)}; });
    add([](Pattern& p) { p.transients = {mild_transient(0.4)}; });
    for (const double amplitude_g : {0.0, 0.8}) {
        add([&](Pattern& p) {
            p.amplitude_g = amplitude_g;
            p.transients = {mild_transient(0.1)};
            p.transients[0].amplitude_g = 0.3;
        });
    }
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].duration_s = 0.05;
    });
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].frequency_hz = 420.0;
    });
    add([](Pattern& p) {
        p.transients = {mild_transient(0.1)};
        p.transients[0].shape = TransientShape::square;
    });
    add([](Pattern& p) {
        for (int k = 0; k < 200; ++k) p.transients.push_back(mild_transient(0.002 * k));
    });
    return all;
}

bool is_source_text(TargetFormat format) {
    return format == TargetFormat::android_kotlin || format == TargetFormat::openxr;
}

TEST_CASE(
    "round trip: of one oddity at a time, each loss has its remark, and what is held has none") {
    const std::vector<Pattern> patterns = odd_patterns();
    for (std::size_t k = 0; k < patterns.size(); ++k) {
        CAPTURE(k);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            if (is_source_text(format) || is_sampled(format)) continue;
            CAPTURE(target_formats()[f].key);
            const auto written = write_effect(format, patterns[k], {"odd", plain_map()});
            const Pattern back = read_back(format, written).effects.front().pattern;
            const bool held = is_plain(patterns[k]) && is_equal(patterns[k], back);
            if (written.remarks.empty() && format != TargetFormat::hjif) CHECK(held);
            if (written.remarks.empty() && is_plain(patterns[k])) CHECK(held);
            if (k == 0 && format != TargetFormat::android_timings && format != TargetFormat::hla) {
                CHECK(written.remarks.empty());
            }
        }
    }
}

TEST_CASE("round trip: no loss is silent") {
    std::mt19937 random(29);
    int lossless = 0;
    for (int k = 0; k < 300; ++k) {
        CAPTURE(k);
        const Pattern pattern = wild_pattern(random);
        for (std::size_t f = 0; f < target_formats().size(); ++f) {
            const auto format = static_cast<TargetFormat>(f);
            CAPTURE(target_formats()[f].key);
            const auto written = write_effect(format, pattern, {"wild \"one\"", plain_map()});
            CHECK(written == write_effect(format, pattern, {"wild \"one\"", plain_map()}));
            if (!written.remarks.empty()) continue;
            CAPTURE(written.text);
            const bool source =
                format == TargetFormat::android_kotlin || format == TargetFormat::openxr;
            if (source || is_sampled(format)) continue;
            const Pattern back = read_back(format, written).effects.front().pattern;
            if (format != TargetFormat::hjif) CHECK(is_plain(pattern));
            if (is_plain(pattern)) CHECK(is_equal(pattern, back));
            ++lossless;
        }
    }
    CHECK(lossless > 50);
}

}  // namespace round_trip_test
