// What 0 to 1 means on an actuator, and the files that say it.
#include <doctest/doctest.h>

#include <cmath>

#include "model/io/effects/actuator_file.h"
#include "model/io/effects/effect.h"
#include "model/io/effects/relaxed_json.h"

namespace actuator_map_test {

using namespace tact;

namespace {

std::string fault(const std::string& text) {
    const auto map = parse_actuator(text, "m.json");
    return map ? "" : map.error().message;
}

ActuatorMap logarithmic() {
    ActuatorMap map;
    map.frequency_hz = {50.0, 200.0};
    map.frequency_law = FrequencyLaw::logarithmic;
    return map;
}

}  // namespace

TEST_CASE("actuator map: a logarithmic law has the geometric mean in its middle") {
    CHECK(frequency_hz(logarithmic(), 0.5) == doctest::Approx(100.0));
    CHECK(frequency_hz(logarithmic(), 0.0) == doctest::Approx(50.0));
    CHECK(frequency_hz(logarithmic(), 7.0) == doctest::Approx(200.0));
}

TEST_CASE("actuator map: a line of shares is drawn so that Hz between its points are right") {
    const FrequencyCurve curve = frequency_curve(logarithmic(), {{0.0, 0.0}, {1.0, 1.0}});
    CHECK(curve.size() > 3);
    for (int k = 0; k <= 100; ++k) {
        const double share = k / 100.0;
        CHECK(std::abs(*frequency_at(curve, share) - 50.0 * std::pow(4.0, share)) < 0.2);
    }
    ActuatorMap squared;
    squared.intensity_law = IntensityLaw::squared;
    const AmplitudeCurve amplitude = acceleration_curve(squared, {{0.0, 0.0}, {1.0, 1.0}});
    for (int k = 0; k <= 100; ++k) {
        const double share = k / 100.0;
        CHECK(std::abs(value_at(amplitude, share) - share * share) < 2e-3);
    }
}

TEST_CASE("actuator map: a straight law keeps the points of a file and adds none") {
    const AmplitudeCurve shares{{0.0, 0.2}, {0.5, 1.0}, {0.5, 0.0}, {2.0, 0.7}};
    CHECK(acceleration_curve(ActuatorMap{}, shares) == shares);
}

TEST_CASE("actuator map: a burst has the energy of the device's, cut or whole") {
    const ActuatorMap& quest = bundled_actuator("quest");
    for (const double cut_s : {1.0, 0.010}) {
        const auto bursts = transients_on(quest, 0.0, 0.5, 0.0, cut_s);
        REQUIRE(bursts.size() == 1);
        double ours = 0.0;
        double theirs = 0.0;
        const double length_s = std::min(cut_s, 0.0364);
        CHECK(bursts[0].duration_s == doctest::Approx(length_s));
        for (int n = 0; n < 4000; ++n) {
            const double t_s = 1e-5 * (n + 0.5);
            const double x =
                t_s < length_s ? 0.5 * std::sin(2.0 * 3.141592653589793 * 55.0 * t_s) : 0;
            theirs += x * x;
            ours += std::pow(transient_g(bursts[0], t_s), 2.0);
        }
        CHECK(ours == doctest::Approx(theirs).epsilon(0.01));
    }
}

TEST_CASE("actuator map: a burst that fades is a row of ever weaker ones") {
    ActuatorMap fading = bundled_actuator("quest");
    fading.fade_out = 1.0;
    const auto bursts = transients_on(fading, 2.0, 1.0, 0.0);
    REQUIRE(bursts.size() == 2);
    CHECK(bursts[0].time_s == 2.0);
    CHECK(bursts[1].time_s == doctest::Approx(2.0 + 1.0 / 55.0));
    CHECK(bursts[1].amplitude_g < 0.5 * bursts[0].amplitude_g);
}

TEST_CASE(
    "actuator map: every bundled one says that its g are assumed, and reads back from a file") {
    for (const ActuatorMap& map : bundled_actuators()) {
        CHECK(map.source.find("1 g at full scale is assumed") != std::string::npos);
        const auto again = parse_actuator(print_actuator(map), "m.json");
        REQUIRE(again);
        CHECK(*again == map);
        CHECK(*actuator_named(map.name) == map);
    }
}

TEST_CASE("actuator map: faulty files are refused at their places") {
    CHECK(fault(R"({"actuator": "x", "frequency_hz": [200, 100]})") ==
          "m.json: /frequency_hz/1: expected at least the lowest frequency, 200 Hz, got 100");
    CHECK(fault(R"({"actuator": "x", "intensity_law": "cubed"})") ==
          "m.json: /intensity_law: expected \"linear\" or \"squared\", got \"cubed\"");
    CHECK(fault(R"({continuous: {gain: 3}, emphasis: {}})") ==
          "m.json: /continuous/gain: expected a number from 0 to 1, got 3");
    CHECK(fault("{}").starts_with("m.json: expected an actuator map"));
    CHECK(fault("{actuator: 'x', // comment\n full_scale_g: }").starts_with("m.json, line 2"));
}

TEST_CASE("relaxed JSON: comments, quotes, keys and commas become strict, and texts stay") {
    CHECK(strict_json("{a: 'x\"y', /* b: 1 */ 'c': [1, 2,], d: true,} // end") ==
          R"({"a": "x\"y",  "c": [1, 2 ], "d": true } )");
    CHECK(strict_json(R"({"a": "// no, comment ,]"})") == R"({"a": "// no, comment ,]"})");
}

}  // namespace actuator_map_test
