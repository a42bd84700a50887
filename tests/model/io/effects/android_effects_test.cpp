// Numbers of small effects of Android, worked out by hand from its documentation.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/io/formats/read_effects.h"
#include "tests/model/io/effects/effects_of.h"

namespace android_effects_test {

using namespace tact;

namespace {

double peak_of(const Pattern& pattern) {
    double peak_g = 0.0;
    for (const double sample_g : render(pattern).samples_g) {
        peak_g = std::max(peak_g, std::abs(sample_g));
    }
    return peak_g;
}

}  // namespace

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
    CHECK(inside("<vendor-effect>AA</vendor-effect>")
              .ends_with("this one's course is the device's own"));
    CHECK(inside(R"(<predefined-effect name="texture_tick"/>)") ==
          "a.x: /vibration-effect/predefined-effect: name: expected click, double_click, "
          "heavy_click or tick, got \"texture_tick\"");
    CHECK(inside(R"(<predefined-effect name="click" fallback="true"/>)") ==
          "a.x: /vibration-effect/predefined-effect: expected no attribute \"fallback\"");
    CHECK(inside(R"(<predefined-effect name="click"/><predefined-effect name="tick"/>)") ==
          "a.x: /vibration-effect: expected one effect, got several");
    CHECK(inside(R"(<primitive-effect name="pop"/>)") ==
          "a.x: /vibration-effect/primitive-effect: name: expected click, low_tick, quick_fall, "
          "quick_rise, slow_rise, spin, thud or tick, got \"pop\"");
    CHECK(inside(R"(<primitive-effect name="click" scale="1.5"/>)") ==
          "a.x: /vibration-effect/primitive-effect: scale: expected a number from 0 to 1, got "
          "\"1.5\"");
    CHECK(inside(R"(<primitive-effect name="click" delayMs="-1"/>)")
              .starts_with("a.x: /vibration-effect/primitive-effect: delayMs: expected a number"));
    CHECK(inside(R"(<primitive-effect name="click" delayType="later"/>)") ==
          "a.x: /vibration-effect/primitive-effect: delayType: expected pause or "
          "relative_start_offset, got \"later\"");
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

TEST_CASE("Android: primitives follow each other, scaled, after their delays") {
    const auto composed = [](const std::string& inside) {
        return only("<vibration-effect>" + inside + "</vibration-effect>");
    };
    const Effect rise = composed(R"(<primitive-effect name="slow_rise" scale="0.5" delayMs="100"/>
      <primitive-effect name="quick_fall" delayMs="20"/>)");
    CHECK(rise.pattern.duration_s == doctest::Approx(0.1 + 0.5 + 0.02 + 0.1));
    CHECK(envelope_g(rise.pattern, 0.05) == 0.0);
    CHECK(envelope_g(rise.pattern, 0.35) == doctest::Approx(0.25));
    CHECK(envelope_g(rise.pattern, 0.599) == doctest::Approx(0.499).epsilon(0.01));
    CHECK(envelope_g(rise.pattern, 0.61) == 0.0);
    CHECK(envelope_g(rise.pattern, 0.67) == doctest::Approx(0.5));
    CHECK(has_remark(rise, "slow_rise: the course is assumed"));
    CHECK(has_remark(rise, "quick_fall: the course is assumed"));
    // A pause begins where the tick before has ended, an offset where that began.
    const Effect ticks = composed(R"(<primitive-effect name="tick"/>
      <primitive-effect name="tick" delayMs="50"/>
      <primitive-effect name="click" delayMs="80" delayType="relative_start_offset"/>)");
    REQUIRE(ticks.pattern.transients.size() == 3);
    const auto& bursts = ticks.pattern.transients;
    CHECK(bursts[0].time_s == 0.0);
    CHECK(bursts[1].time_s == doctest::Approx(bursts[0].duration_s + 0.05));
    CHECK(bursts[2].time_s == doctest::Approx(bursts[1].time_s + 0.08));
    CHECK(bursts[2].amplitude_g == doctest::Approx(2.0 * bursts[0].amplitude_g).epsilon(0.1));
    CHECK(bursts[0].frequency_hz == doctest::Approx(30.0 + 0.9 * 270.0));
    CHECK(bursts[2].frequency_hz == doctest::Approx(30.0 + 0.6 * 270.0));
    for (const char* name :
         {"click", "tick", "low_tick", "thud", "spin", "quick_rise", "slow_rise", "quick_fall"}) {
        CAPTURE(name);
        const std::string node = std::string("<primitive-effect name=\"") + name + "\" ";
        const Effect whole = composed(node + "/>");
        const Effect half = composed(node + "scale=\"0.5\"/>");
        CHECK(whole.pattern.duration_s > 0.01);
        const double whole_g = peak_of(whole.pattern);
        CHECK(whole_g > 0.1);
        CHECK(peak_of(half.pattern) == doctest::Approx(0.5 * whole_g).epsilon(0.01));
    }
}

TEST_CASE("Android: a predefined effect is one of four, alone, and assumed") {
    const auto predefined = [](const std::string& name) {
        return only("<vibration-effect><predefined-effect name=\"" + name +
                    "\"/></vibration-effect>");
    };
    CHECK(predefined("click").pattern ==
          only(R"(<vibration-effect><primitive-effect name="click"/></vibration-effect>)").pattern);
    const auto& twice = predefined("double_click").pattern.transients;
    REQUIRE(twice.size() == 2);
    CHECK(twice[1].time_s == doctest::Approx(0.13));
    CHECK(has_remark(predefined("heavy_click"), "heavy_click: the course is assumed"));
    CHECK(peak_of(predefined("tick").pattern) < peak_of(predefined("click").pattern));
}

}  // namespace android_effects_test
