// Numbers of small files of each format, worked out by hand from their specifications.
#include <doctest/doctest.h>

#include <random>

#include "model/io/effects/read_effects.h"
#include "model/pattern/drawn_fault.h"
#include "tests/support/mutations.h"

namespace effect_formats_test {

using namespace tact;

namespace {

EffectsRead read(const std::string& text) {
    const auto effects = read_effects(text, "a.x");
    REQUIRE_MESSAGE(effects, (effects ? "" : effects.error().message));
    return *effects;
}

Effect only(const std::string& text) {
    const EffectsRead all = read(text);
    REQUIRE(all.effects.size() == 1);
    return all.effects.front();
}

std::string fault(const std::string& text) {
    const auto effects = read_effects(text, "a.x");
    return effects ? "" : effects.error().message;
}

bool has_remark(const Effect& effect, const std::string& words) {
    for (const std::string& remark : effect.remarks) {
        if (remark.find(words) != remark.npos) return true;
    }
    return false;
}

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

std::string hjif(const std::string& bands, const std::string& version = "2023") {
    return R"({"version": ")" + version +
           R"(", "timescale": 1000, "perceptions": [{"channels": [{"gain": 1, "bands": )" + bands +
           "}]}]}";
}

std::string wave(const std::string& phase, const std::string& keyframes) {
    return R"({"band_type": "VectorialWave", "lower_frequency_limit": 60, "upper_frequency_limit": 300, "effects":
      [{"effect_type": "Basis", "position": 0, "phase": )" +
           phase + R"(, "base_signal": "Sine", "keyframes": )" + keyframes + "}]}";
}

const std::string kEnvelopeXml =
    R"(<vibration-effect><waveform-envelope-effect initialFrequencyHz="20">
  <control-point amplitude="0.5" frequencyHz="80" durationMs="10"/>
  <control-point amplitude="0.25" frequencyHz="150" durationMs="30"/></waveform-envelope-effect></vibration-effect>)";

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

TEST_CASE("HJIF: waves of one envelope are carriers of one pattern, with their phases") {
    const std::string low =
        R"([{"relative_position": 0, "amplitude_modulation": 0.8, "frequency_modulation": 80},
                                {"relative_position": 500, "amplitude_modulation": 0.4}])";
    const std::string high =
        R"([{"relative_position": 0, "amplitude_modulation": 0.4, "frequency_modulation": 240},
                                 {"relative_position": 500, "amplitude_modulation": 0.2}])";
    const Effect effect = only(hjif("[" + wave("0", low) + "," + wave("1.5", high) + "]"));
    const Pattern& pattern = effect.pattern;
    CHECK(effect.remarks.empty());
    REQUIRE(pattern.carriers.size() == 2);
    CHECK(pattern.carriers[0] == Carrier{80.0, 1.0, 0.0});
    CHECK(pattern.carriers[1] == Carrier{240.0, 0.5, 1.5});
    CHECK(envelope_g(pattern, 0.25) == doctest::Approx(0.6));
    CHECK(pattern.frequency_curve.empty());
}

TEST_CASE("HJIF: waves of different envelopes are merged by energy, with a remark") {
    const std::string flat =
        R"([{"relative_position": 0, "amplitude_modulation": 0.3, "frequency_modulation": 80},
                                 {"relative_position": 400, "amplitude_modulation": 0.3}])";
    const std::string step =
        R"([{"relative_position": 0, "amplitude_modulation": 0.4, "frequency_modulation": 200},
            {"relative_position": 200, "amplitude_modulation": 0.4}])";
    std::string late = wave("0", step);
    late.replace(late.find("\"position\": 0"), 13, "\"position\": 200");
    const Effect effect = only(hjif("[" + wave("0", flat) + "," + late + "]"));
    CHECK(has_remark(effect, "vibrations at one time are merged"));
    CHECK(envelope_g(effect.pattern, 0.3) == doctest::Approx(0.5));
    CHECK(first_carrier_hz(effect.pattern, 0.3) == doctest::Approx(200.0));
}

TEST_CASE("HJIF: older files with negative amplitudes and no frequencies are read with remarks") {
    const Effect effect = only(hjif(
        "[" +
            wave(
                "0",
                R"([{"relative_position": 0, "amplitude_modulation": -0.5}, {"relative_position": 100, "amplitude_modulation": -0.5}])") +
            "]",
        "1"));
    CHECK(has_remark(effect, "negative amplitudes"));
    CHECK(has_remark(effect, "middle of their band"));
    CHECK(has_remark(effect, "version \"1\" read as 2023"));
    CHECK(effect.pattern.carriers.front().frequency_hz == 180.0);
    CHECK(envelope_g(effect.pattern, 0.05) == doctest::Approx(0.5));
}

TEST_CASE("HJIF: references take their effect from the library, or are refused") {
    const std::string text = R"({"version": "2023", "perceptions": [{"effect_library": [
      {"id": 7, "keyframes": [{"relative_position": 0, "amplitude_modulation": 1, "frequency_modulation": 90},
                              {"relative_position": 100, "amplitude_modulation": 1}]}],
      "channels": [{"bands": [{"band_type": "VectorialWave", "effects": [
        {"effect_type": "Reference", "id": 7, "position": 50}]}]}]}]})";
    const Pattern pattern = only(text).pattern;
    CHECK(pattern.duration_s == doctest::Approx(0.15));
    CHECK(pattern.carriers.front().frequency_hz == 90.0);
    CHECK(envelope_g(pattern, 0.04) == 0.0);
    std::string wrong = text;
    wrong.replace(wrong.find("\"id\": 7, \"position"), 7, "\"id\": 8");
    CHECK(fault(wrong) ==
          "a.x: /perceptions/0/channels/0/bands/0/effects/0/id: expected the id of an "
          "effect in the library, got 8.0");
}

TEST_CASE("Android: timings and amplitudes are steps of 255ths") {
    const Pattern pattern =
        only(R"({"timings": [100, 50, 50, 200], "amplitudes": [255, 0, 0, 51], "repeat": -1})")
            .pattern;
    CHECK(pattern.duration_s == doctest::Approx(0.4));
    CHECK(pattern.amplitude_curve ==
          AmplitudeCurve{{0.0, 1.0}, {0.1, 1.0}, {0.1, 0.0}, {0.2, 0.0}, {0.2, 0.2}, {0.4, 0.2}});
    CHECK(fault(R"({"timings": [100, 50], "amplitudes": [255]})") ==
          "a.x: /amplitudes: expected as many as there are timings, 2, got 1");
    CHECK(fault(R"({"timings": [0], "amplitudes": [255]})") ==
          "a.x: /timings: expected a sum above 0 ms");
    const Effect off_first = only(R"({"timings": [100, 50], "repeat": 0})");
    CHECK(envelope_g(off_first.pattern, 0.05) == 0.0);
    CHECK(envelope_g(off_first.pattern, 0.12) == 1.0);
    CHECK(has_remark(off_first, "repeats for ever"));
}

TEST_CASE("Android: an envelope of waveforms starts at amplitude 0 and at its first Hz") {
    const Pattern pattern = only(kEnvelopeXml).pattern;
    CHECK(pattern.duration_s == doctest::Approx(0.04));
    CHECK(envelope_g(pattern, 0.005) == doctest::Approx(0.25));
    CHECK(envelope_g(pattern, 0.025) == doctest::Approx(0.375));
    CHECK(first_carrier_hz(pattern, 0.0) == doctest::Approx(20.0));
    CHECK(first_carrier_hz(pattern, 0.025) == doctest::Approx(115.0));
}

TEST_CASE("Android: a basic envelope is a share of decibels above threshold") {
    const Effect effect = only(R"(<vibration-effect><basic-envelope-effect>
      <control-point intensity="1" sharpness="0.5" durationMs="100"/>
      <control-point intensity="0.5" sharpness="1" durationMs="100"/>
      <control-point intensity="0" sharpness="1" durationMs="100"/></basic-envelope-effect></vibration-effect>)");
    CHECK(envelope_g(effect.pattern, 0.1) == doctest::Approx(1.0));
    CHECK(envelope_g(effect.pattern, 0.2) == doctest::Approx(0.1));
    CHECK(first_carrier_hz(effect.pattern, 0.15) == doctest::Approx(30 + 0.75 * 270));
    CHECK(has_remark(effect, "40 dB above threshold are guessed"));
}

TEST_CASE("Android: what the platform's parser refuses is refused at its place") {
    const auto inside = [](const std::string& text) {
        return fault("<vibration-effect>" + text + "</vibration-effect>");
    };
    CHECK(
        inside(
            R"(<waveform-envelope-effect><control-point amplitude="-1" frequencyHz="80" durationMs="10"/></waveform-envelope-effect>)") ==
        "a.x: /vibration-effect/waveform-envelope-effect/control-point: amplitude: expected a "
        "number from 0 to 1, got \"-1\"");
    CHECK(
        inside(
            R"(<basic-envelope-effect><control-point intensity="0.2" sharpness="0.8" durationMs="100"/></basic-envelope-effect>)") ==
        "a.x: /vibration-effect/basic-envelope-effect/control-point: intensity: expected 0 at the "
        "end of a basic envelope");
    CHECK(inside("<waveform-envelope-effect/>") ==
          "a.x: /vibration-effect/waveform-envelope-effect: expected at least one <control-point>, "
          "got none");
    CHECK(
        inside(
            R"(<waveform-effect><waveform-entry durationMs="0" amplitude="10"/></waveform-effect>)") ==
        "a.x: /vibration-effect/waveform-effect: expected entries of more than 0 ms");
    CHECK(
        inside(
            R"(<waveform-effect><repeating><waveform-entry durationMs="10" amplitude="1"/></repeating><waveform-entry durationMs="10" amplitude="1"/></waveform-effect>)") ==
        "a.x: /vibration-effect/waveform-effect: expected <waveform-entry> and one <repeating> at "
        "the end, got \"repeating\"");
    CHECK(inside(R"(<predefined-effect name="click"/>)")
              .ends_with("this one's course is the device's own"));
    CHECK(inside("") == "a.x: /vibration-effect: expected an effect, got none");
    CHECK(fault("<vibration-effect><waveform").starts_with("a.x, line 1, column "));
}

TEST_CASE("Android: preamble, entries and repeating part are played once, one after the other") {
    const Effect entries = only(
        R"(<vibration-effect><waveform-effect><waveform-entry durationMs="10" amplitude="default"/>
      <repeating><waveform-entry durationMs="30" amplitude="51"/></repeating></waveform-effect></vibration-effect>)");
    CHECK(entries.pattern.duration_s == doctest::Approx(0.04));
    CHECK(envelope_g(entries.pattern, 0.005) == 1.0);
    CHECK(envelope_g(entries.pattern, 0.02) == doctest::Approx(0.2));
    CHECK(has_remark(entries, "once here"));
    const std::string point = R"(<control-point amplitude="1" frequencyHz="100" durationMs="20"/>)";
    const std::string envelope =
        "<waveform-envelope-effect>" + point + "</waveform-envelope-effect>";
    const EffectsRead two = read(
        "<vibration-select><vibration-effect><repeating-effect><preamble>" + envelope +
        "</preamble><repeating>" + envelope + "</repeating></repeating-effect></vibration-effect>" +
        "<vibration-effect>" + envelope + "</vibration-effect></vibration-select>");
    REQUIRE(two.effects.size() == 2);
    CHECK(two.effects[0].pattern.duration_s == doctest::Approx(0.04));
    CHECK(envelope_g(two.effects[0].pattern, 0.03) == doctest::Approx(0.5));
    CHECK(two.effects[1].name == "a 2");
}

TEST_CASE("effects: the kind of a file is what is in it, and anything else is none of them") {
    CHECK(read(kAhap).format == EffectFormat::ahap);
    CHECK(read(kHe).format == EffectFormat::he);
    CHECK(read(kHaps).format == EffectFormat::haps);
    CHECK(read(kPulsar).format == EffectFormat::pulsar);
    CHECK(read(kEnvelopeXml).format == EffectFormat::android);
    CHECK(read(R"({"Timings": [5], "Amplitudes": [5]})").format == EffectFormat::hla);
    CHECK(read(R"({"Pattern": [{"Event": {"Type": "transient", "RelativeTime": 0,
        "Parameters": {"Intensity": 1, "Frequency": 1}}}]})")
              .format == EffectFormat::he);
    CHECK(read("{}").format == EffectFormat::none);
    CHECK(read("[1, 2]").format == EffectFormat::none);
    CHECK(read("<svg/>").format == EffectFormat::none);
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

}  // namespace effect_formats_test
