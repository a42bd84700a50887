// Compositions of Android's primitives, read and written again.
#include <doctest/doctest.h>

#include <array>
#include <random>

#include "model/io/formats/android/android_primitives.h"
#include "tests/model/io/effects_out/written_patterns.h"

namespace android_primitives_test {

using namespace tact;
using namespace tact::written_patterns;

namespace {

constexpr std::array<const char*, 8> kNames{"click", "tick",       "low_tick",  "thud",
                                            "spin",  "quick_rise", "slow_rise", "quick_fall"};

const ActuatorMap& android() { return bundled_actuator("android"); }

Pattern read_xml(const std::string& text) {
    const auto read = read_effects(text, "a.xml", android());
    INFO((read ? "" : read.error().message));
    REQUIRE(read);
    REQUIRE(read->effects.size() == 1);
    return read->effects.front().pattern;
}

// Scales of two digits, pauses of whole ms, or offsets into the one before.
std::string some_composition(std::mt19937& random) {
    std::string text = "<vibration-effect>\n";
    const std::size_t count = 1 + random() % 6;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t name = random() % kNames.size();
        text += std::string("    <primitive-effect name=\"") + kNames[name] + "\"";
        const std::size_t hundredths = 20 + random() % 81;
        if (hundredths < 100) {
            const std::string digits = std::to_string(hundredths);
            text += " scale=\"0." + (digits.back() == '0' ? digits.substr(0, 1) : digits) + "\"";
        }
        const std::size_t pause_ms = random() % 3 == 0 ? 0 : 1 + random() % 200;
        if (pause_ms > 0) text += " delayMs=\"" + std::to_string(pause_ms) + "\"";
        text += "/>\n";
    }
    return text + "</vibration-effect>\n";
}

}  // namespace

TEST_CASE("primitives: a composition is written as it was read, and sounds the same") {
    std::mt19937 random(3);
    for (int k = 0; k < 200; ++k) {
        const std::string text = some_composition(random);
        CAPTURE(text);
        const Pattern pattern = read_xml(text);
        const WrittenEffect written =
            write_effect(TargetFormat::android_xml, pattern, {"one", android()});
        CHECK(written.text == text);
        CHECK(same_transients(pattern, read_xml(written.text)));
    }
}

TEST_CASE(
    "primitives: one that overlaps is left out, as the platform does, and Kotlin says the rest") {
    const Pattern pattern = read_xml(
        "<vibration-effect>\n"
        "    <primitive-effect name=\"slow_rise\" scale=\"0.8\"/>\n"
        "    <primitive-effect name=\"tick\" delayMs=\"200\" "
        "delayType=\"relative_start_offset\"/>\n"
        "    <primitive-effect name=\"quick_fall\" delayMs=\"540\" "
        "delayType=\"relative_start_offset\"/>\n"
        "</vibration-effect>\n");
    CHECK(pattern.transients.empty());
    CHECK(pattern.duration_s == doctest::Approx(0.64));
    const WrittenEffect kotlin =
        write_effect(TargetFormat::android_kotlin, pattern, {"one", android()});
    CHECK(kotlin.text.find("startComposition()\n"
                           "    .addPrimitive(VibrationEffect.Composition.PRIMITIVE_SLOW_RISE, "
                           "0.8f, 0)\n"
                           "    .addPrimitive(VibrationEffect.Composition.PRIMITIVE_QUICK_FALL, "
                           "1f, 40)\n"
                           "    .compose()\n") != std::string::npos);
    // A tick drawn into the rise is something that no composition can hold.
    Pattern with_tick = pattern;
    with_tick.transients = read_xml(
                               "<vibration-effect><primitive-effect name=\"tick\" "
                               "delayMs=\"200\"/></vibration-effect>")
                               .transients;
    CHECK(!as_primitives(with_tick, android()));
}

TEST_CASE("primitives: what differs by a hair is no primitive any more") {
    const Pattern click =
        read_xml(R"(<vibration-effect><primitive-effect name="click"/></vibration-effect>)");
    REQUIRE(as_primitives(click, android()));
    Pattern other = click;
    other.transients[0].frequency_hz += 1.0;
    CHECK(!as_primitives(other, android()));
    other = click;
    other.transients[0].duration_s += 0.001;
    CHECK(!as_primitives(other, android()));
    other = click;
    other.transients[0].amplitude_g *= 1.01;  // above what the device can
    CHECK(!as_primitives(other, android()));
    const Pattern rise =
        read_xml(R"(<vibration-effect><primitive-effect name="quick_rise"/></vibration-effect>)");
    REQUIRE(as_primitives(rise, android()));
    for (const auto change :
         {+[](Pattern& p) { p.modulation.frequency_hz = 10.0; },
          +[](Pattern& p) { p.amplitude_curve.front().value = 0.2; },
          +[](Pattern& p) { p.frequency_curve.back().frequency_hz += 5.0; },
          +[](Pattern& p) { p.attack_s = 0.02; }, +[](Pattern& p) { p.duration_s += 0.1; }}) {
        Pattern changed = rise;
        change(changed);
        CHECK(!as_primitives(changed, android()));
    }
    std::mt19937 random(5);
    for (int k = 0; k < 200; ++k) CHECK(!as_primitives(some_pattern(random, {}), android()));
}

}  // namespace android_primitives_test
