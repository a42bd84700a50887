// Numbers of small HJIF files, worked out by hand from ISO/IEC 23090-31.
#include <doctest/doctest.h>

#include "model/io/formats/read_effects.h"
#include "tests/model/io/effects/effects_of.h"

namespace hjif_test {

using namespace tact;

namespace {

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

}  // namespace

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

TEST_CASE(
    "HJIF: waves of different envelopes at once are layers, and merged where one pattern has to "
    "do") {
    const std::string flat =
        R"([{"relative_position": 0, "amplitude_modulation": 0.3, "frequency_modulation": 80},
                                 {"relative_position": 400, "amplitude_modulation": 0.3}])";
    const std::string step =
        R"([{"relative_position": 0, "amplitude_modulation": 0.4, "frequency_modulation": 200},
            {"relative_position": 200, "amplitude_modulation": 0.4}])";
    std::string late = wave("0", step);
    late.replace(late.find("\"position\": 0"), 13, "\"position\": 200");
    const Effect effect = only(hjif("[" + wave("0", flat) + "," + late + "]"));
    CHECK_FALSE(has_remark(effect, "vibrations at one time are merged"));
    CHECK(has_remark(effect, "2 courses at once are layers"));
    REQUIRE(effect.layers.size() == 2);
    CHECK(effect.layers[0].carriers[0].frequency_hz == 80.0);
    CHECK(envelope_g(effect.layers[0], 0.1) == doctest::Approx(0.3));
    CHECK(envelope_g(effect.layers[0], 0.3) == doctest::Approx(0.3));
    CHECK(envelope_g(effect.layers[1], 0.1) == 0.0);
    CHECK(envelope_g(effect.layers[1], 0.3) == doctest::Approx(0.4));
    CHECK(first_carrier_hz(effect.layers[1], 0.3) == doctest::Approx(200.0));
    CHECK(envelope_g(effect.pattern, 0.3) == doctest::Approx(0.5));
    CHECK(first_carrier_hz(effect.pattern, 0.3) == doctest::Approx(200.0));
}

TEST_CASE(
    "HJIF: what sounds one after the other, or in more courses than there are layers, is merged") {
    const auto burst = [](int at_ms, double share, int hz) {
        std::string band = wave(
            "0", R"([{"relative_position": 0, "amplitude_modulation": )" + std::to_string(share) +
                     R"(, "frequency_modulation": )" + std::to_string(hz) +
                     R"(}, {"relative_position": 100, "amplitude_modulation": )" +
                     std::to_string(share / 2.0) + "}]");
        band.replace(band.find("\"position\": 0"), 13, "\"position\": " + std::to_string(at_ms));
        return band;
    };
    CHECK(only(hjif("[" + burst(0, 0.5, 80) + "," + burst(100, 0.4, 200) + "]")).layers.empty());
    std::string five = burst(0, 0.5, 80);
    for (int k = 1; k < 5; ++k) five += "," + burst(10 * k, 0.4, 100 + 20 * k);
    const Effect merged = only(hjif("[" + five + "]"));
    CHECK(merged.layers.empty());
    CHECK(has_remark(merged, "vibrations at one time are merged"));
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

TEST_CASE("HJIF: a position before 0 that lost its sign is the beginning, a late one is late") {
    const auto frames = [](const char* first, const char* last) {
        return std::string(R"([{"relative_position": )") + first +
               R"(, "amplitude_modulation": 0.2, "frequency_modulation": 80},
                   {"relative_position": 0, "amplitude_modulation": 0.8},
                   {"relative_position": )" +
               last + R"(, "amplitude_modulation": 0.4}])";
    };
    const Effect effect = only(hjif("[" + wave("0", frames("65534", "400")) + "]"));
    CHECK(has_remark(effect, "65534 before 0 are taken as -2"));
    CHECK(effect.pattern.duration_s == doctest::Approx(0.4));
    CHECK(envelope_g(effect.pattern, 0.2) == doctest::Approx(0.6));
    CHECK(fault(hjif("[" + wave("0", frames("30000", "400")) + "]")) != "");
    const Effect late = only(hjif("[" + wave("0", R"([{"relative_position": 0,
        "amplitude_modulation": 0.8, "frequency_modulation": 80},
        {"relative_position": 40000, "amplitude_modulation": 0.4}])") +
                                  "]"));
    CHECK(late.pattern.duration_s == doctest::Approx(40.0));
}

TEST_CASE("HJIF: \"Other\" over bands of vibration is one, said; another sense is left out") {
    const std::string steady =
        R"([{"relative_position": 0, "amplitude_modulation": 0.5, "frequency_modulation": 80},
            {"relative_position": 500, "amplitude_modulation": 0.5}])";
    std::string text = hjif("[" + wave("0", steady) + "]");
    const std::string begin = R"("perceptions": [{)";
    text.insert(text.find(begin) + begin.size(), R"("perception_modality": "Other", )");
    CHECK(has_remark(only(text), "\"Other\" is taken as a vibration"));
    text.replace(text.find("Other"), 5, "Wind!");
    CHECK(fault(text) != "");
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

}  // namespace hjif_test
