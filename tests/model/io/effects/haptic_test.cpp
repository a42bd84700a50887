// Meta's .haptic, held against its renderer's published rules (tests/golden/make_effects.py).
#include <doctest/doctest.h>

#include <cmath>

#include "model/io/effects/actuator_file.h"
#include "model/io/formats/read_effects.h"
#include "tests/support/golden.h"

namespace haptic_test {

using namespace tact;

namespace {

Effect only_effect(const std::string& text, const std::optional<ActuatorMap>& map = {}) {
    const auto read = read_effects(text, "a.haptic", map);
    REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
    REQUIRE(read->effects.size() == 1);
    return read->effects.front();
}

std::string fault(const std::string& text) {
    const auto read = read_effects(text, "a.haptic");
    return read ? "" : read.error().message;
}

std::string clip(const std::string& amplitude, const std::string& frequency = "[]",
                 const std::string& editor = "me") {
    return R"({"version": {"major": 1}, "metadata": {"editor": ")" + editor +
           R"("}, "signals": {"continuous": {"envelopes": {"amplitude": )" + amplitude +
           R"(, "frequency": )" + frequency + "}}}}";
}

std::vector<double> rms_of_20_ms(const Waveform& waveform) {
    constexpr std::size_t kFrame = 200;
    std::vector<double> result;
    for (std::size_t n = 0; n + kFrame <= waveform.samples_g.size(); n += kFrame) {
        double sum = 0.0;
        for (std::size_t k = n; k < n + kFrame; ++k) {
            sum += waveform.samples_g[k] * waveform.samples_g[k];
        }
        result.push_back(std::sqrt(sum / kFrame));
    }
    return result;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum_a = 0.0, sum_b = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        sum_a += a[k];
        sum_b += b[k];
    }
    const double mean_a = sum_a / static_cast<double>(a.size());
    const double mean_b = sum_b / static_cast<double>(b.size());
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        ab += (a[k] - mean_a) * (b[k] - mean_b);
        aa += (a[k] - mean_a) * (a[k] - mean_a);
        bb += (b[k] - mean_b) * (b[k] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("haptic: envelopes of 20 ms are those of the format's own renderer") {
    for (const auto& item : golden::read("effects.json", "haptic")) {
        CAPTURE(item.at("name"));
        const auto map = parse_actuator(item.at("acf").get<std::string>(), "golden.acf");
        REQUIRE(map);
        const Effect effect = only_effect(item.at("haptic"), *map);
        const std::vector<double> expected = item.at("rms_20_ms");
        const std::vector<double> got = rms_of_20_ms(render(effect.pattern));
        REQUIRE(got.size() == expected.size());
        CHECK(correlation(got, expected) >= 0.99);
        // Correlation alone would not see a wrong scale.
        CHECK(mean(got) == doctest::Approx(mean(expected)).epsilon(0.02));
    }
}

TEST_CASE("haptic: points keep their times, and frequencies lie between 55 and 200 Hz") {
    const Pattern pattern =
        only_effect(clip(R"([{"time": 0, "amplitude": 0.2}, {"time": 0.5, "amplitude": 1}])",
                         R"([{"time": 0, "frequency": 0}, {"time": 0.25, "frequency": 0.4}])"))
            .pattern;
    CHECK(pattern.duration_s == 0.5);
    CHECK(pattern.amplitude_g == 1.0);
    CHECK(pattern.amplitude_curve == AmplitudeCurve{{0.0, 0.2}, {0.5, 1.0}});
    REQUIRE(pattern.frequency_curve.size() == 3);
    CHECK(pattern.frequency_curve[0] == FrequencyPoint{0.0, 55.0});
    CHECK(pattern.frequency_curve[1].frequency_hz == doctest::Approx(113.0));
    CHECK(pattern.frequency_curve[2].frequency_hz == doctest::Approx(113.0));
}

TEST_CASE("haptic: without frequencies it is in the middle of the range") {
    const Pattern pattern =
        only_effect(clip(R"([{"time": 0, "amplitude": 1}, {"time": 1, "amplitude": 1}])")).pattern;
    CHECK(pattern.frequency_curve.empty());
    CHECK(pattern.carriers.front().frequency_hz == 127.5);
}

TEST_CASE("haptic: an emphasis is a burst that halves what is beneath it") {
    const Pattern pattern = only_effect(clip(R"([{"time": 0, "amplitude": 0.4},
                             {"time": 0.1, "amplitude": 0.4,
                              "emphasis": {"amplitude": 0.8, "frequency": 1}},
                             {"time": 0.2, "amplitude": 0.4}])"))
                                .pattern;
    REQUIRE(pattern.transients.size() == 1);
    const Transient& burst = pattern.transients.front();
    CHECK(burst.time_s == 0.1);
    CHECK(burst.frequency_hz == 165.0);
    CHECK(burst.duration_s == doctest::Approx(0.0121));
    CHECK(burst.shape == TransientShape::square);
    // A square wave without flanks beside one with Hann flanks over half of it: sqrt(1 / 0.6875).
    CHECK(burst.amplitude_g == doctest::Approx(0.8 * 1.20605).epsilon(0.002));
    CHECK(amplitude_factor(pattern, 0.099) == doctest::Approx(0.4));
    CHECK(amplitude_factor(pattern, 0.101) == doctest::Approx(0.2));
    CHECK(amplitude_factor(pattern, 0.1120) == doctest::Approx(0.2));
    CHECK(amplitude_factor(pattern, 0.1122) == doctest::Approx(0.4));
}

TEST_CASE("haptic: what its specification calls invalid is refused at its place") {
    const std::string envelopes = "a.haptic: /signals/continuous/envelopes";
    CHECK(fault(clip(R"([{"time": 0, "amplitude": 0.2}, {"time": 1, "amplitude": 1.2}])")) ==
          envelopes + "/amplitude/1/amplitude: expected a number from 0 to 1, got 1.2");
    CHECK(fault(clip(R"([{"time": 1, "amplitude": 0.2}, {"time": 0.5, "amplitude": 1}])")) ==
          envelopes + "/amplitude/1/time: expected a time not before the last point's, got 0.5");
    CHECK(fault(clip(R"([{"time": 0, "amplitude": 0.2}, {"amplitude": 1}])")) ==
          envelopes + "/amplitude/1/time: expected a number, it is missing");
    CHECK(fault(R"({"version": {"major": 2}, "signals": {}})") ==
          "a.haptic: /version/major: expected 1, got 2.0");
    CHECK(fault(R"({"signals": {}})") ==
          "a.haptic: /version: expected {\"major\": 1, ..}, it is missing");
    CHECK(fault(R"({"version": {"major": 1}, "signals": {}})") ==
          envelopes + "/amplitude: expected an array of at least 2 points, it is missing");
}

TEST_CASE("haptic: a frequency behind the end passes in files of a studio alone") {
    const std::string amplitude = R"([{"time": 0, "amplitude": 1}, {"time": 1, "amplitude": 1}])";
    const std::string frequency = R"([{"time": 0, "frequency": 0}, {"time": 2, "frequency": 1}])";
    CHECK(fault(clip(amplitude, frequency)) ==
          "a.haptic: /signals/continuous/envelopes/frequency/1/time: expected a time within the "
          "amplitude envelope, got 2.0");
    const Effect effect = only_effect(clip(amplitude, frequency, "Lofelt GmbH"));
    CHECK(effect.remarks ==
          std::vector<std::string>{"frequency points behind the end are left out"});
    CHECK(first_carrier_hz(effect.pattern, 1.0) == doctest::Approx(127.5));
}

TEST_CASE(
    "haptic: what lasts longer than a pattern can is cut, and says so; its points are all there") {
    std::string points = R"([{"time": 0, "amplitude": 0})";
    for (int k = 1; k <= 1400; ++k) {
        points += R"(, {"time": )" + std::to_string(0.05 * k) + R"(, "amplitude": )" +
                  std::to_string(0.5 + 0.4 * std::sin(0.3 * k)) + "}";
    }
    const Effect effect = only_effect(clip(points + "]"));
    CHECK(effect.pattern.duration_s == 60.0);
    CHECK(effect.pattern.amplitude_curve.size() == 1201);
    CHECK(effect.remarks ==
          std::vector<std::string>{"cut at 60 s of 70 s, as long as a pattern can be"});
}

}  // namespace haptic_test
