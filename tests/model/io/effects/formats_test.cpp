// Numbers of small files of each format, worked out by hand from their specifications.
#include <doctest/doctest.h>

#include <random>

#include "model/io/formats/read_effects.h"
#include "model/pattern/drawn_fault.h"
#include "tests/support/mutations.h"

namespace effect_formats_test {

using namespace tact;

namespace {

const std::string kAhap = R"({"Version": 1, "Pattern": [
  {"Event": {"Time": 0.1, "EventType": "HapticContinuous", "EventDuration": 0.4, "EventParameters": [
    {"ParameterID": "HapticIntensity", "ParameterValue": 0.5},
    {"ParameterID": "HapticSharpness", "ParameterValue": 0.2}]}},
  {"Event": {"Time": 0.4, "EventType": "HapticTransient", "EventParameters": [
    {"ParameterID": "HapticIntensity", "ParameterValue": 1},
    {"ParameterID": "HapticSharpness", "ParameterValue": 0.4}]}},
  {"ParameterCurve": {"ParameterID": "HapticIntensityControl", "Time": 0.2,
    "ParameterCurveControlPoints": [{"Time": 0, "ParameterValue": 1},
                                    {"Time": 0.2, "ParameterValue": 0.5}]}},
  {"Parameter": {"ParameterID": "HapticSharpnessControl", "Time": 0.3, "ParameterValue": 0.1}},
]})";

const std::string kHe = R"({"MetaData": {"Version": 1.0, "ChannelNumber": 1}, "Channels": [
  {"Parameters": {"Index": 0}, "Pattern": [
    {"Event": {"Type": "transient", "StartTime": 10, "Parameters": {"Frequency": 25, "Intensity": 80}}},
    {"Event": {"Type": "continuous", "StartTime": 40, "Duration": 60,
      "Parameters": {"Frequency": 30, "Intensity": 50, "Curve": [
        {"Time": 0, "Frequency": 0, "Intensity": 0}, {"Time": 20, "Frequency": 20, "Intensity": 1},
        {"Time": 60, "Frequency": -30, "Intensity": 0.5}]}}}]}]})";

const std::string kHaps =
    R"({"m_version": "5", "m_gain": 0.5, "m_vibration": {"m_gain": 1, "m_melodies": [
  {"m_mute": 0, "m_gain": 0.8, "m_notes": [
    {"m_startingPoint": 0.5, "m_length": 0.022, "m_gain": 1.25, "m_hapticEffect": {"m_type": 0}}]},
  {"m_mute": 0, "m_gain": 1, "m_notes": [
    {"m_startingPoint": 0.1, "m_length": 0.2, "m_gain": 1, "m_hapticEffect": {
      "m_amplitudeModulation": {"m_keyframes": [{"m_time": 0, "m_value": 0}, {"m_time": 0.4, "m_value": 1}]},
      "m_frequencyModulation": {"m_keyframes": [{"m_time": 0, "m_value": 100}, {"m_time": 0.2, "m_value": 200}]}}}]},
  {"m_mute": 1, "m_notes": [{"m_startingPoint": 5}]}]}})";

const std::string kPulsar = R"({"name": "Tap", "duration": 500, "continuousPattern": {
  "amplitude": [{"time": 100, "value": 0.5}, {"time": 300, "value": 1}],
  "frequency": [{"time": 100, "value": 0}, {"time": 300, "value": 1}]},
  "discretePattern": [{"time": 50, "amplitude": 1, "frequency": 0.5}, {"time": 400, "amplitude": 0, "frequency": 0}]})";

}  // namespace

TEST_CASE(
    "AHAP: intensity controls multiply, sharpness controls add, times count from the curve's") {
    const Effect effect = only(kAhap);
    const Pattern& pattern = effect.pattern;
    CHECK(pattern.duration_s == 0.5);
    CHECK(pattern.amplitude_g == doctest::Approx(0.6138));
    CHECK(envelope_g(pattern, 0.05) == 0.0);
    CHECK(envelope_g(pattern, 0.15) == doctest::Approx(0.6138 * 0.5));
    CHECK(envelope_g(pattern, 0.3) == doctest::Approx(0.6138 * 0.5 * 0.75));
    CHECK(envelope_g(pattern, 0.45) == doctest::Approx(0.6138 * 0.5 * 0.5));
    CHECK(first_carrier_hz(pattern, 0.2) == doctest::Approx(65 + 0.2 * 235));
    CHECK(first_carrier_hz(pattern, 0.35) == doctest::Approx(65 + 0.3 * 235));
    REQUIRE(pattern.transients.size() == 1);
    CHECK(pattern.transients[0].time_s == 0.4);
    CHECK(pattern.transients[0].frequency_hz == doctest::Approx(65 + 0.5 * 235));
    CHECK(pattern.transients[0].duration_s == 0.022);
    CHECK(pattern.transients[0].amplitude_g == doctest::Approx(0.792 * 0.5 * 1.206).epsilon(0.02));
    CHECK(has_remark(effect, "commas and quotes that JSON does not allow"));
}

TEST_CASE("AHAP: the square law halves an intensity of 0.5 once more, also between points") {
    const auto squared = read_effects(kAhap, "a.x", bundled_actuator("core-haptics-squared"));
    REQUIRE(squared);
    const Pattern& pattern = squared->effects.front().pattern;
    CHECK(envelope_g(pattern, 0.15) == doctest::Approx(0.6138 * 0.25));
    CHECK(envelope_g(pattern, 0.3) == doctest::Approx(0.6138 * 0.375 * 0.375).epsilon(0.01));
}

TEST_CASE("AHAP: what Core Haptics clamps or does not play is clamped or left out, with a remark") {
    const Effect effect = only(R"({"Pattern": [
      {"Event": {"EventType": "HapticTransient", "EventParameters": [
        {"ParameterID": "HapticIntensity", "ParameterValue": 7}, {"ParameterID": "AttackTime", "ParameterValue": 0.5}]}},
      {"Event": {"EventType": "AudioCustom", "EventWaveformPath": "x.wav"}}], "Metadata": {"a": 1}})");
    CHECK(has_remark(effect, "intensity out of range is clamped"));
    CHECK(has_remark(effect, "\"AttackTime\" of events is left out"));
    CHECK(has_remark(effect, "its sounds are left out"));
    CHECK(fault(R"({"Pattern": [{"Event": {"EventType": "Hum"}}]})") ==
          "a.x: /Pattern/0/Event/EventType: expected HapticTransient, HapticContinuous, "
          "AudioContinuous or AudioCustom, got \"Hum\"");
    CHECK(fault(R"({"Pattern": []})") ==
          "a.x: /Pattern: expected an array of 1 to 100000, got an array of 0");
}

TEST_CASE(
    "AHAP: points in the file's time, as Meta's writer has them, are taken so with a remark") {
    const std::string head = R"({"Pattern": [
      {"Event": {"EventType": "HapticContinuous", "EventDuration": 1, "EventParameters": [
        {"ParameterID": "HapticSharpness", "ParameterValue": 0}]}},
      {"ParameterCurve": {"ParameterID": "HapticSharpnessControl", "Time": 0.4,
        "ParameterCurveControlPoints": [{"Time": )";
    const std::string tail = R"(, "ParameterValue": 0}, {"Time": 0.5, "ParameterValue": 1}]}}]})";
    const Effect absolute = only(head + "0.4" + tail);
    CHECK(has_remark(absolute, "taken as the file's, not the curve's"));
    CHECK(first_carrier_hz(absolute.pattern, 0.45) == doctest::Approx(182.5));
    const Effect relative = only(head + "0.0" + tail);
    CHECK(!has_remark(relative, "taken as the file's"));
    CHECK(first_carrier_hz(relative.pattern, 0.65) == doctest::Approx(182.5));
}

TEST_CASE("he: intensity multiplies its curve, frequency adds, channel 0 is one pattern") {
    const Effect effect = only(kHe);
    const Pattern& pattern = effect.pattern;
    CHECK(effect.name == "a");
    CHECK(pattern.duration_s == doctest::Approx(0.1));
    CHECK(envelope_g(pattern, 0.02) == 0.0);
    CHECK(envelope_g(pattern, 0.06) == doctest::Approx(0.5));
    CHECK(envelope_g(pattern, 0.08) == doctest::Approx(0.375));
    CHECK(first_carrier_hz(pattern, 0.06) == doctest::Approx(150.0));
    CHECK(first_carrier_hz(pattern, 0.1) == doctest::Approx(50.0));
    REQUIRE(pattern.transients.size() == 1);
    CHECK(pattern.transients[0].time_s == 0.01);
    CHECK(pattern.transients[0].frequency_hz == doctest::Approx(100.0));
}

TEST_CASE("he: sides that differ are two patterns, and other types are refused") {
    std::string two = R"({"PatternList": [{"AbsoluteTime": 100, "Pattern": [
      {"Event": {"Type": "transient", "RelativeTime": 5, "Index": 1, "Parameters": {"Frequency": 0, "Intensity": 100}}},
      {"Event": {"Type": "transient", "RelativeTime": 5, "Index": 2, "Parameters": {"Frequency": 0, "Intensity": 50}}}]}]})";
    const EffectsRead sides = read(two);
    REQUIRE(sides.effects.size() == 2);
    CHECK(sides.effects[0].name == "a left");
    CHECK(sides.effects[1].name == "a right");
    CHECK(sides.effects[0].pattern.transients[0].time_s == 0.105);
    CHECK(sides.effects[0].pattern.transients[0].amplitude_g ==
          doctest::Approx(2.0 * sides.effects[1].pattern.transients[0].amplitude_g));
    two.replace(two.find("transient"), 9, "hum");
    CHECK(fault(two) ==
          "a.x: /PatternList/0/Pattern/0/Event/Type: expected \"transient\" or \"continuous\", got "
          "\"hum\"");
}

TEST_CASE("haps: gains multiply, keyframes end with their note, Hz are the file's") {
    const Effect effect = only(kHaps);
    const Pattern& pattern = effect.pattern;
    CHECK(envelope_g(pattern, 0.2) == doctest::Approx(0.5 * 0.25));
    CHECK(envelope_g(pattern, 0.2999) == doctest::Approx(0.5 * 0.5).epsilon(0.001));
    CHECK(envelope_g(pattern, 0.31) == 0.0);
    CHECK(first_carrier_hz(pattern, 0.2) == doctest::Approx(150.0));
    REQUIRE(pattern.transients.size() == 1);
    CHECK(pattern.transients[0].duration_s == 0.022);
    CHECK(pattern.transients[0].amplitude_g == doctest::Approx(0.5 * 1.206).epsilon(0.02));
    CHECK(pattern.duration_s == doctest::Approx(0.522));
    CHECK(has_remark(effect, "muted melodies are left out"));
}

TEST_CASE("Pulsar: ms, 65 to 300 Hz, silent outside of its points") {
    const Pattern pattern = only(kPulsar).pattern;
    CHECK(pattern.duration_s == 0.5);
    CHECK(envelope_g(pattern, 0.09) == 0.0);
    CHECK(envelope_g(pattern, 0.2) == doctest::Approx(0.6138 * 0.75));
    CHECK(envelope_g(pattern, 0.31) == 0.0);
    CHECK(first_carrier_hz(pattern, 0.2) == doctest::Approx(182.5));
    REQUIRE(pattern.transients.size() == 1);
    CHECK(pattern.transients[0].frequency_hz == doctest::Approx(182.5));
}

TEST_CASE("effects: the kind of a file is what is in it, and anything else is none of them") {
    CHECK(read(kAhap).format == format_named("ahap"));
    CHECK(read(kHe).format == format_named("he"));
    CHECK(read(kHaps).format == format_named("haps"));
    CHECK(read(kPulsar).format == format_named("pulsar"));
    CHECK(read(kEnvelopeXml).format == format_named("android"));
    CHECK(read(R"({"Timings": [5], "Amplitudes": [5]})").format == format_named("hla"));
    CHECK(read(R"({"Pattern": [{"Event": {"Type": "transient", "RelativeTime": 0,
        "Parameters": {"Intensity": 1, "Frequency": 1}}}]})")
              .format == format_named("he"));
    CHECK(read("{}").format == nullptr);
    CHECK(read("[1, 2]").format == format_named("web"));
    CHECK(read("[[1, 2]]").format == nullptr);
    CHECK(read("<svg/>").format == nullptr);
}

TEST_CASE("effects: damaged texts give a sentence or sound patterns") {
    std::mt19937 random(7);
    for (const std::string& whole : {kAhap, kHe, kHaps, kPulsar, kEnvelopeXml}) {
        for (int round = 0; round < 400; ++round) {
            const std::string text = after_mishaps(whole, random);
            CAPTURE(text);
            const auto effects = read_effects(text, "damaged");
            if (!effects) {
                CHECK(effects.error().message.starts_with("damaged"));
                continue;
            }
            for (const Effect& effect : effects->effects) {
                CHECK(!drawn_fault(effect.pattern));
                CHECK(effect.pattern == clamped(effect.pattern));
            }
        }
    }
}

TEST_CASE("formats: what a file says of itself stands in the note, with its tags") {
    const auto note_of = [](const std::string& text) {
        const auto read = read_effects(text, "buzz.json");
        REQUIRE_MESSAGE(read, read.error().message);
        return origin_of(*read, read->effects.at(0), "buzz.json");
    };
    const std::string pulsar =
        R"("discretePattern": [{"time": 0, "amplitude": 1, "frequency": 0.3}],
        "continuousPattern": {"amplitude": [], "frequency": []}, "duration": 50)";
    CHECK(note_of("{" + pulsar + "}").starts_with("From buzz.json"));
    CHECK(note_of(
              R"({"name": "Glow", "description": "Dissolves gently.", "tags": ["Bold", "Soft"],)" +
              pulsar + "}")
              .starts_with("Glow: Dissolves gently. Tags: Bold, Soft. From buzz.json"));
    CHECK(note_of(R"({"description": " Ends ", "tags": "none", "name": 3,)" + pulsar + "}")
              .starts_with("Ends. From buzz.json"));
    CHECK(note_of(R"({"tags": [1, "", "One"],)" + pulsar + "}")
              .starts_with("Tags: One. From buzz.json"));
    const std::string haptic = R"({"version": {"major": 1, "minor": 0, "patch": 0},
        "metadata": {"description": "Two points", "tags": ["a", "b"]}, "signals": {"continuous":
        {"envelopes": {"amplitude": [{"time": 0, "amplitude": 1}, {"time": 1, "amplitude": 1}]}}}})";
    CHECK(note_of(haptic).starts_with("Two points. Tags: a, b. From buzz.json"));
}

}  // namespace effect_formats_test
