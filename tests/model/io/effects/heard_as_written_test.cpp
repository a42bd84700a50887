// What is heard is what a file says: ticks at its end, curves, scales, silence.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "model/io/formats/read_effects.h"
#include "model/pattern/pattern.h"

namespace heard_as_written_test {

using namespace tact;

namespace {

double energy_behind(const Pattern& pattern, double t_s) {
    const Waveform waveform = render(pattern);
    double sum = 0.0;
    for (std::size_t n = sample_count(t_s, 1e4); n < waveform.samples_g.size(); ++n) {
        sum += waveform.samples_g[n] * waveform.samples_g[n];
    }
    return sum;
}

Effect effect_of(const std::string& text) {
    const auto read = read_effects(text, "a.x", {});
    REQUIRE(read);
    REQUIRE(!read->effects.empty());
    return read->effects.front();
}

std::string fault_of(const std::string& text) {
    const auto read = read_effects(text, "a.x", {});
    return read ? "" : read.error().message;
}

bool says(const Effect& effect, const std::string& words) {
    for (const std::string& remark : effect.remarks) {
        if (remark.find(words) != std::string::npos) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("heard: a last tick at the stated end sounds as long as the one before it") {
    const std::string two[] = {
        R"({"name": "t", "duration": 200, "continuousPattern": {"amplitude": [], "frequency": []},
            "discretePattern": [{"time": 0, "amplitude": 1, "frequency": 0.5},
                                {"time": 200, "amplitude": 1, "frequency": 0.5}]})",
        R"({"name": "t", "continuousPattern": {"amplitude": [], "frequency": []},
            "discretePattern": [{"time": 0, "amplitude": 1, "frequency": 0.5},
                                {"time": 200, "amplitude": 1, "frequency": 0.5}]})",
        R"({"Pattern": [{"Event": {"Time": 0, "EventType": "HapticTransient"}},
                        {"Event": {"Time": 0.2, "EventType": "HapticTransient"}}]})",
        R"({"Metadata": {"Version": 1}, "Pattern": [
            {"Event": {"Type": "transient", "RelativeTime": 0, "Parameters": {"Intensity": 100, "Frequency": 50}}},
            {"Event": {"Type": "transient", "RelativeTime": 200, "Parameters": {"Intensity": 100, "Frequency": 50}}}]})",
        R"({"m_version": "5", "m_vibration": {"m_melodies": [{"m_notes": [
            {"m_startingPoint": 0, "m_length": 0.022, "m_hapticEffect": {"m_type": 0}},
            {"m_startingPoint": 0.2, "m_length": 0.022, "m_hapticEffect": {"m_type": 0}}]}]}})"};
    for (const std::string& text : two) {
        CAPTURE(text);
        const Pattern pattern = effect_of(text).pattern;
        REQUIRE(pattern.transients.size() == 2);
        const double behind = energy_behind(pattern, 0.2);
        CHECK(behind > 0.0);
        CHECK(energy_behind(pattern, 0.0) == doctest::Approx(2.0 * behind).epsilon(0.02));
    }
}

TEST_CASE("heard: a last pulse of a format without ticks sounds as the one before it") {
    const std::string two[] = {
        R"({"timings": [20, 180, 20], "amplitudes": [255, 0, 255]})",
        R"({"ProjectName": "p", "TrackName": "t", "Duration": 220, "Timings": [20, 180, 20],
            "Amplitudes": [255, 0, 255], "Repeat": -1, "RequiredAudioFiles": [], "Audios": []})",
        R"(<vibration-effect><waveform-effect><waveform-entry durationMs="20" amplitude="255"/>
            <waveform-entry durationMs="180" amplitude="0"/>
            <waveform-entry durationMs="20" amplitude="255"/></waveform-effect></vibration-effect>)",
        R"({"version": {"major": 1, "minor": 0, "patch": 0}, "signals": {"continuous": {"envelopes": {
            "amplitude": [{"time": 0, "amplitude": 0, "emphasis": {"amplitude": 1, "frequency": 0.5}},
                          {"time": 0.2, "amplitude": 0,
                           "emphasis": {"amplitude": 1, "frequency": 0.5}}]}}}})",
        R"({"version": "2023", "profile": "Main", "level": 1, "date": "2026-01-01",
            "description": "", "timescale": 1000, "avatars": [], "syncs": [], "perceptions": [
            {"id": 0, "avatar_id": 0, "description": "", "perception_modality": "Vibrotactile",
             "reference_devices": [], "effect_library": [], "channels": [{"id": 0, "description": "",
             "gain": 1, "mixing_coefficient": 1, "body_part_mask": 0, "bands": [
             {"band_type": "Transient", "lower_frequency_limit": 0, "upper_frequency_limit": 1000,
              "effects": [
              {"effect_type": "Basis", "position": 0, "phase": 0, "base_signal": "Sine",
               "keyframes": [{"relative_position": 0, "amplitude_modulation": 1,
                              "frequency_modulation": 150}]},
              {"effect_type": "Basis", "position": 200, "phase": 0, "base_signal": "Sine",
               "keyframes": [{"relative_position": 0, "amplitude_modulation": 1,
                              "frequency_modulation": 150}]}]}]}]}]})"};
    for (const std::string& text : two) {
        CAPTURE(text);
        const Pattern pattern = effect_of(text).pattern;
        const double behind = energy_behind(pattern, 0.2);
        CHECK(behind > 0.0);
        CHECK(energy_behind(pattern, 0.0) == doctest::Approx(2.0 * behind).epsilon(0.1));
    }
}

TEST_CASE("heard: a last tick without strength still says how long a preset of Pulsar is") {
    const Effect effect = effect_of(
        R"({"name": "t", "continuousPattern": {"amplitude": [], "frequency": []}, "discretePattern": [
            {"time": 0, "amplitude": 1, "frequency": 0}, {"time": 300, "amplitude": 0, "frequency": 0}]})");
    CHECK(effect.pattern.duration_s == 0.3);
}

TEST_CASE("heard: curves of an AHAP count from their own time where one late curve says so") {
    const auto curve = [](const std::string& id, const std::string& first) {
        return R"({"ParameterCurve": {"ParameterID": ")" + id +
               R"(", "Time": 0.1, "ParameterCurveControlPoints": [{"Time": )" + first +
               R"(, "ParameterValue": 1}, {"Time": 0.4, "ParameterValue": 0}]}})";
    };
    const std::string head = R"({"Pattern": [{"Event": {"EventType": "HapticContinuous",
        "EventDuration": 1}}, )";
    const Effect mixed = effect_of(head + curve("HapticSharpnessControl", "0") + ", " +
                                   curve("HapticIntensityControl", "0.1") + "]}");
    CHECK(!says(mixed, "taken as the file's"));
    CHECK(envelope_g(mixed.pattern, 0.45) > 0.0);
    CHECK(envelope_g(mixed.pattern, 0.51) == 0.0);
    const Effect absolute = effect_of(head + curve("HapticSharpnessControl", "0.1") + ", " +
                                      curve("HapticIntensityControl", "0.1") + "]}");
    CHECK(says(absolute, "taken as the file's"));
    CHECK(envelope_g(absolute.pattern, 0.41) == 0.0);
}

TEST_CASE("heard: vibrations that end where the next begins, but for rounding, leave no gap") {
    // 0.1 + 0.2 is 0.30000000000000004.
    const Effect effect = effect_of(R"({"Pattern": [
        {"Event": {"Time": 0.1, "EventType": "HapticContinuous", "EventDuration": 0.2}},
        {"Event": {"Time": 0.3, "EventType": "HapticContinuous", "EventDuration": 0.2}},
        {"Event": {"Time": 0.50000005, "EventType": "HapticContinuous", "EventDuration": 0.2}}]})");
    CHECK(!says(effect, "merged"));
    const double full_g = envelope_g(effect.pattern, 0.2);
    CHECK(envelope_g(effect.pattern, 0.3) == doctest::Approx(full_g));
    for (const AmplitudePoint& point : effect.pattern.amplitude_curve) {
        const bool inside = point.time_s > 0.1 && point.time_s < 0.69;
        if (inside) CHECK(point.value > 0.9);
    }
}

TEST_CASE("heard: times of seconds and amplitudes of shares are refused by their numbers") {
    CHECK(fault_of(R"({"timings": [0.1, 0.65], "amplitudes": [255, 100]})") ==
          "a.x: expected times in ms, the greatest of all is 0.65 ms: these may be seconds");
    CHECK(fault_of(R"({"name": "t", "continuousPattern": {"amplitude": [{"time": 0, "value": 1},
          {"time": 0.65, "value": 0}], "frequency": []}, "discretePattern": []})")
              .find("0.65 ms: these may be seconds") != std::string::npos);
    CHECK(fault_of(R"({"Metadata": {"Version": 1}, "Pattern": [{"Event": {"Type": "continuous",
          "RelativeTime": 0, "Duration": 0.4, "Parameters": {"Intensity": 100, "Frequency": 50}}}]})")
              .find("0.4 ms: these may be seconds") != std::string::npos);
    CHECK(fault_of(R"({"timings": [100, 200], "amplitudes": [0.5, 1]})") ==
          "a.x: /amplitudes: expected amplitudes from 0 to 255, the greatest of all is 1: these "
          "may be shares of 1");
    CHECK(fault_of(R"({"timings": [100, 200], "amplitudes": [0, 2]})").empty());
}

TEST_CASE("heard: silence is named") {
    CHECK(says(effect_of(R"({"timings": [100, 200], "amplitudes": [0, 0]})"), "it is silent"));
    CHECK(!says(effect_of(R"({"timings": [100, 200], "amplitudes": [0, 9]})"), "it is silent"));
}

TEST_CASE(
    "heard: every tick and every note of a file is there, or the file's rest is cut, and said") {
    for (const int notes : {20, 120, 126, 210, 400, 700}) {
        CAPTURE(notes);
        std::string events;
        for (int k = 0; k < notes; ++k) {
            events +=
                (k == 0 ? "" : ", ") + (R"({"Event": {"Time": )" + std::to_string(0.1 * k) +
                                        R"(, "EventType": "HapticContinuous", "EventDuration": 0.05,
                       "EventParameters": [{"ParameterID": "HapticIntensity", "ParameterValue": )" +
                                        std::to_string(0.5 + 0.1 * (k % 5)) + "}]}}");
        }
        const Effect effect = effect_of(R"({"Pattern": [)" + events + "]}");
        const Pattern& pattern = effect.pattern;
        CHECK(says(effect, "cut at") == (notes > 600));
        CHECK_FALSE(says(effect, "thinned"));
        CHECK(pattern.duration_s == doctest::Approx(std::min(60.0, 0.1 * notes - 0.05)));
        for (int k = 0; 0.1 * k + 0.1 < pattern.duration_s; ++k) {
            const double level = (0.5 + 0.1 * (k % 5)) / 0.5;
            CHECK(amplitude_factor(pattern, 0.1 * k + 0.025) / amplitude_factor(pattern, 0.025) ==
                  doctest::Approx(level));
            CHECK(amplitude_factor(pattern, 0.1 * k + 0.075) == 0.0);
        }
    }
}

TEST_CASE(
    "heard: more ticks than a pattern holds are cut in time, weak ones kept among strong ones") {
    std::string events;
    for (int k = 0; k < 11'000; ++k) {
        events += (k == 0 ? "" : ", ") + (R"({"Event": {"Time": )" + std::to_string(0.003 * k) +
                                          R"(, "EventType": "HapticTransient", "EventParameters": [
                   {"ParameterID": "HapticIntensity", "ParameterValue": )" +
                                          (k % 2 == 0 ? "1" : "0.3") + "}]}}");
    }
    const Effect effect = effect_of(R"({"Pattern": [)" + events + "]}");
    const std::vector<Transient>& ticks = effect.pattern.transients;
    CHECK(says(effect, "cut at 30 s of 33.02 s: 10,000 of 11,000 transients"));
    CHECK(effect.pattern.duration_s == doctest::Approx(30.0));
    REQUIRE(ticks.size() == 10'000);
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        CHECK(ticks[k].time_s == doctest::Approx(0.003 * static_cast<double>(k)));
        CHECK(ticks[k].amplitude_g == ticks[k % 2].amplitude_g);
    }
}

}  // namespace heard_as_written_test
