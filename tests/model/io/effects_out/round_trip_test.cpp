// What is written, read back by our own readers with the same actuator map.
#include <doctest/doctest.h>

#include "tests/model/io/effects_out/written_patterns.h"

namespace round_trip_test {

using namespace tact;
using namespace tact::written_patterns;

namespace {

constexpr int kPatterns = 60;  // of each format

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

TEST_CASE("round trip: each of 210 and of 2,000 notes keeps its strength, and each gap is silent") {
    for (const int count : {210, 2'000}) {
        Pattern pattern;
        pattern.rhythm.unit_s = 0.014;
        for (int k = 0; k < count; ++k) {
            pattern.rhythm.text += k % 10 == 0 ? 'x' : static_cast<char>('0' + k % 10);
            pattern.rhythm.text += '-';
        }
        pattern.duration_s = count * 0.028;
        for (const TargetFormat format : {TargetFormat::ahap, TargetFormat::haptic}) {
            CAPTURE(traits(format).key);
            const WrittenEffect written = write_effect(format, pattern, {"one", plain_map()});
            const Pattern back = read_back(written.text).effects.front().pattern;
            double most = 0.0;
            for (int k = 0; k < count; ++k) {
                const double note_s = (k + 0.25) * 0.028;
                const double gap_s = (k + 0.75) * 0.028;
                const double strength = envelope_g(pattern, note_s);
                most = std::max(most, std::abs(envelope_g(back, note_s) / strength - 1.0));
                most = std::max(most, envelope_g(back, gap_s));
            }
            CHECK(most < 0.01);
        }
    }
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

}  // namespace round_trip_test
